// What the contacts of a crowd are computed on: plain arrays of small records, indexed within the
// crowd, so that kernels load whole records and solve kContactLanes contacts side by side.
//
// Spins are kept as surface speeds, radius times angular velocity: with them a tangent impulse
// changes both balls alike, and no kernel needs a radius.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wells {

inline constexpr std::size_t kContactLanes = 8;

/// Where a ball is.
struct alignas(32) Place {
  double x = 0, y = 0, z = 0;  // m
  double radius = 0;           // m
};

/// What impulses change.
struct alignas(64) Momentum {
  double vx = 0, vy = 0, vz = 0;  // m/s
  double inverseMass = 0;         // 1/kg; 0: does not move
  double sx = 0, sy = 0, sz = 0;  // m/s, radius times angular velocity
  double unused = 0;
};

/// By how much forces changed the velocity in the flight of a substep.
struct alignas(32) Gained {
  double vx = 0, vy = 0, vz = 0;  // m/s
  double unused = 0;
};

/// What a contact carries from substep to substep.
struct alignas(32) LastingImpulse {
  double normal = 0;              // N s, >= 0
  double tx = 0, ty = 0, tz = 0;  // N s on a, in the tangent plane
};

struct IndexPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// Pairs between the balls of a crowd, those of a ball as a together, in the order of the balls.
struct PairsByBall {
  std::span<const IndexPair> pairs;
  std::span<const std::uint32_t> firstOf;  // by ball, in pairs; one more behind the last ball
};

/// Contacts that share no ball, while they are solved.
struct alignas(64) ContactBlock {
  std::uint32_t a[kContactLanes];
  std::uint32_t b[kContactLanes];
  std::uint32_t pair[kContactLanes];  // in the lists of pairs and lasting impulses
  std::uint32_t count = 0;            // of lanes in use, the first ones
  // Normal from a to b; unit.
  alignas(64) double nx[kContactLanes];
  double ny[kContactLanes];
  double nz[kContactLanes];
  double mass[kContactLanes];    // kg, along the normal
  double bounce[kContactLanes];  // m/s, separating speed that is asked for; < 0: it may close
  double normal[kContactLanes];  // N s, impulses as LastingImpulse has them
  double tx[kContactLanes];
  double ty[kContactLanes];
  double tz[kContactLanes];
};

/// Of the same contacts, what is needed before and after.
struct alignas(64) ContactFlight {
  double gap[kContactLanes];        // m, at the end of the flight
  double closing[kContactLanes];    // m/s, likewise
  double builtUp[kContactLanes];    // m/s, by which forces made it close in the substep
  double lasts[kContactLanes];      // 1; 0: an impact
  double rubShifts[kContactLanes];  // 1; 0: forces move a ball too far within the substep
};

}  // namespace wells
