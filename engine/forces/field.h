// The acceleration field of a world, its potential beside it so that energy cannot drift from
// force.
#pragma once

#include <cstdint>
#include <limits>

#include "forces/field_wells.h"
#include "math/vector.h"
#include "state/world.h"

namespace wells {

/// Gravity and wells as they act during one step. Drag is not a field: see dragFactor.
struct Field {
  Vec3 gravity = Vec3::Zero();  // m/s^2
  FieldWells wells = {};        // switched on ones only
  /// The step is divided into so many stretches of flight of so many seconds, which resolve the
  /// sharpest well: see stretchesOf.
  std::int64_t stretches = 1;
  double stretch = std::numeric_limits<double>::infinity();
};

/// The field of the step that starts now.
Field fieldOf(const World& world);

/// Makes `field` that of the step that starts at `step`, in the memory that it has.
void updateField(const World& world, std::int64_t step, Field& field);

/// Into how many equal stretches a step of dt seconds is divided, so that none is longer than
/// kStretchPhase / omega, omega^2 = max |S| / softening^3 being the curvature at the centre of the
/// sharpest well. The same for all balls and, while the wells keep their strengths, for all steps:
/// what is symplectic at a fixed step stays so. At most kMostStretches.
std::int64_t stretchesOf(const FieldWells& wells, double dt);

/// The same for one well, before rounding and without a limit.
double stretchesWanted(double strength, double softening, double dt);

inline constexpr double kStretchPhase = 0.25;  // rad
inline constexpr std::int64_t kMostStretches = 10'000;

/// Acceleration (m/s^2) at `position` (m), `t` seconds after the start of the step.
inline Vec3 acceleration(const Field& field, const Vec3& position, double t) {
  Vec3 sum = field.gravity;
  for (const Well& well : field.wells) {
    const Vec3 d = well.position + well.velocity * t - position;
    const double s2 = squaredLength(d) + well.softening * well.softening;
    sum += d * (well.strength / (s2 * std::sqrt(s2)));
  }
  return sum;
}

/// Potential energy per mass (m^2/s^2) at `position`, `t` seconds after the start of the step.
/// Gravity's is zero at `origin`.
inline double potentialAt(const Field& field, const Vec3& position, const Vec3& origin, double t) {
  double sum = -dot(field.gravity, position - origin);
  for (const Well& well : field.wells) {
    const Vec3 d = well.position + well.velocity * t - position;
    sum -= well.strength / std::sqrt(squaredLength(d) + well.softening * well.softening);
  }
  return sum;
}

/// The same at the start of the step.
inline double potential(const Field& field, const Vec3& position, const Vec3& origin) {
  return potentialAt(field, position, origin, 0);
}

/// By how much (m^2/s^3) the potential at a fixed position changes because wells move.
inline double potentialRate(const Field& field, const Vec3& position, double t) {
  double sum = 0;
  for (const Well& well : field.wells) {
    const Vec3 d = well.position + well.velocity * t - position;
    const double s2 = squaredLength(d) + well.softening * well.softening;
    sum += well.strength * dot(d, well.velocity) / (s2 * std::sqrt(s2));
  }
  return sum;
}

/// The rate k (1/s) at which drag slows, v' = -k v; 0 without drag.
double dragRate(double drag);

/// What drag multiplies a velocity by over h seconds: drag^h, drag being the factor per second
/// (the report's d). Exactly 1 without drag.
double dragFactor(double drag, double h);

}  // namespace wells
