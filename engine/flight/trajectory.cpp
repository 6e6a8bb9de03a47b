#include "flight/trajectory.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace wells {

BallState stateAt(const FlightModel& model, const Trajectory& path, double t) {
  BallState state = path.state;
  if (t <= path.start) return state;
  const std::uint32_t ball = 0;
  model.integrator->fly({model.field, path.start, t - path.start, model.drag}, {&ball, 1},
                        &state.position, &state.velocity);
  return state;
}

double accelerationBound(const FlightModel& model, const BallState& ball, double t,
                         double duration) {
  const double speed = length(ball.velocity);
  double strongest = 0;
  for (const Well& well : model.field->wells)
    strongest += std::abs(well.strength) / (well.softening * well.softening);
  strongest *= 2 / (3 * std::sqrt(3.0));
  const double fastest =
      speed + (strongest + length(model.field->gravity)) * duration;  // m/s, drag only slows
  double bound = model.drag == 1 ? 0 : -naturalLogarithm(model.drag) * fastest;
  for (const Well& well : model.field->wells) {
    const Vec3 d = well.position + well.velocity * t - ball.position;
    const double e2 = well.softening * well.softening;
    const double s2 = squaredLength(d) + e2;
    const double now = std::abs(well.strength) * length(d) / (s2 * std::sqrt(s2));
    const double steepness = std::abs(well.strength) / (e2 * well.softening);
    const double limit = 2 / (3 * std::sqrt(3.0)) * std::abs(well.strength) / e2;
    bound += std::min(limit, now + steepness * (fastest + length(well.velocity)) * duration);
  }
  return bound;
}

}  // namespace wells
