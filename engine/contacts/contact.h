// One contact, and the exact geometry of spheres against spheres, the ground plane and the inside
// of the wall. No polygons, no tolerances.
#pragma once

#include <cmath>
#include <cstdint>

#include "state/arena.h"
#include "state/balls.h"

namespace wells {

/// A possible contact of ball a with ball b, the ground or the wall. The normal points from a to b;
/// impulses are those on a along -normal and in the tangent plane, on b the opposite.
struct Contact {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Vec3 normal = Vec3::Zero();          // unit
  double gap = 0;                      // m; < 0 is overlap
  double inverseMassA = 0;             // 1/kg
  double inverseMassB = 0;             // 1/kg; 0: ground or wall
  bool acts = false;                   // touches, so that it may push in the substep at hand
  bool isPulled = false;               // forces act along the normal
  bool isCoarse = false;               // forces move a ball too far within the substep
  bool isMoving = false;               // the two balls move against each other, not only by forces
  bool isSmall = false;                // its island is small enough to be solved directly
  bool isSolved = false;               // in this substep, together with its island
  bool isSlow = false;                 // closes no faster than forces explain
  bool impact = false;                 // closes faster than forces explain: an instant, not a rest
  double bounceSpeed = 0;              // m/s, separating speed that restitution asks for
  double builtUp = 0;                  // m/s, by which forces made it close in the substep
  double closingFlown = 0;             // m/s, at the end of the substep, before any impulse
  double restedImpulse = 0;            // N s, normal, of the substep before; 0: did not rest in it
  double share = 0;                    // 0 .. 1, of the substep, in which its force acted
  double normalImpulse = 0;            // N s, >= 0, of the last substep
  Vec3 tangentImpulse = Vec3::Zero();  // N s on a, of the last substep
  Vec3 rollingImpulse = Vec3::Zero();  // N m s, the torque of rolling resistance on a, likewise
};

/// Some direction for two balls whose centres coincide, so that a push-out has somewhere to go. It
/// depends on the ids alone: the same everywhere, and a clump of many balls bursts to all sides.
inline Vec3 directionOfIds(std::uint32_t a, std::uint32_t b) {
  std::uint64_t bits = (std::uint64_t{a} << 32 | b) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 32;
  const auto component = [&](int place) {  // never 0
    return static_cast<double>(bits >> (20 * place) & 0xfffff) + 0.5 - 0x80000;
  };
  const Vec3 direction(component(0), component(1), component(2));
  return direction / length(direction);
}

/// Unit vector from a to b and the gap between two spheres.
inline void touchBalls(const Balls& balls, Contact& c) {
  const Vec3 d = balls.position[c.b] - balls.position[c.a];
  const double distance = length(d);
  c.normal = distance > 0 ? Vec3(d / distance) : directionOfIds(c.a, c.b);
  c.gap = distance - (balls.radius[c.a] + balls.radius[c.b]);
}

inline double groundGap(const Arena& arena, const Vec3& position, double radius) {
  return position.y() - arena.center.y() - radius;
}

inline double wallGap(const Arena& arena, const Vec3& position, double radius) {
  const double x = position.x() - arena.center.x();
  const double z = position.z() - arena.center.z();
  return arena.radius - radius - std::sqrt(x * x + z * z);
}

/// The normal points out of the arena: down at the ground, outward at the wall. On the axis the
/// wall has no nearest point; there the normal is +x.
inline void touchArena(const Arena& arena, const Balls& balls, Contact& c) {
  const Vec3& position = balls.position[c.a];
  if (c.b == kGround) {
    c.normal = {0, -1, 0};
    c.gap = groundGap(arena, position, balls.radius[c.a]);
    return;
  }
  const double x = position.x() - arena.center.x();
  const double z = position.z() - arena.center.z();
  const double fromAxis = std::sqrt(x * x + z * z);
  c.normal = fromAxis > 0 ? Vec3(x / fromAxis, 0, z / fromAxis) : Vec3(1, 0, 0);
  c.gap = arena.radius - balls.radius[c.a] - fromAxis;
}

inline void touch(const Arena& arena, const Balls& balls, Contact& c) {
  if (isBall(c.b))
    touchBalls(balls, c);
  else
    touchArena(arena, balls, c);
}

/// How fast the gap shrinks, m/s.
inline double closingSpeed(const Balls& balls, const Contact& c) {
  const double a = dot(balls.velocity[c.a], c.normal);
  return isBall(c.b) ? a - dot(balls.velocity[c.b], c.normal) : a;
}

/// What touches and is pressed together rests: gaps up to kClosedGap (m) times the size of the
/// coordinates, and closing speeds up to kClosingNoise times the speeds that they are made of, are
/// what rounding leaves of zero.
inline constexpr double kClosedGap = 1e-15;
inline constexpr double kClosingNoise = 1e-14;

/// A contact that closes no faster than this many times the speed which forces gave one of its
/// balls within the substep rests.
inline constexpr double kRestFactor = 2;

inline double withoutNoise(double closing, double speed) {
  return std::abs(closing) <= kClosingNoise * speed ? 0 : closing;
}

}  // namespace wells
