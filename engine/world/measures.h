// What can be said about a world at one instant. Computed only when asked for.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "forces/field.h"
#include "state/world.h"

namespace wells {

/// Sums over balls.
struct Mechanics {
  double kineticEnergy = 0;             // J, translation and rotation
  double potentialEnergy = 0;           // J, of gravity (zero at the arena's centre) and wells
  Vec3 momentum = Vec3::Zero();         // kg m/s
  Vec3 angularMomentum = Vec3::Zero();  // kg m^2/s about the arena's centre, spin included

  double energy() const { return kineticEnergy + potentialEnergy; }  // J
};

/// J, translation and rotation: of ball i; of all whose state is finite, in O(N).
double kineticEnergy(const Balls& balls, std::size_t i);
double kineticEnergy(const Balls& balls);

/// Adds ball i, in the field `t` seconds after the start of its step.
void addMechanics(const World& world, const Field& field, double t, std::size_t i, Mechanics& sum);

struct Measures : Mechanics {
  double ballOverlap = 0;           // m, worst ball-ball overlap; 0: none
  double groundOverlap = 0;         // m, deepest ball below the ground
  double wallOverlap = 0;           // m, furthest ball beyond the wall
  double squaredOverlaps = 0;       // m^2, sum of the squares of all overlaps of the three kinds
  std::int64_t ballContacts = 0;    // pairs of balls that overlap
  std::int64_t groundContacts = 0;  // balls that reach below the ground
  std::int64_t wallContacts = 0;    // balls that reach beyond the wall
  std::int64_t escaped = 0;         // balls whose centre is below the ground or beyond the wall,
                                    // or whose state is not finite

  double worstOverlap() const;  // m, of the three
};

/// Cost: O(N log N + pairs close along x). A ball whose state is not finite counts as escaped and
/// in nothing else.
Measures measure(const World& world);

/// The same over the given balls alone (overlaps: of these among themselves).
Measures measure(const World& world, std::span<const std::uint32_t> balls);

/// 64 bits that depend on every bit of the balls' states and on the step.
std::uint64_t stateHash(const World& world);

/// 16 lower-case hexadecimal digits, as reports print a hash.
std::string hashText(std::uint64_t hash);

}  // namespace wells
