#include "contacts/path.h"

#include <algorithm>
#include <cmath>

#include "contacts/support.h"
#include "math/elementary.h"

namespace wells {
namespace {

/// By wells and drag, of a ball in flight.
double flightBound(const PathModel& model, const BallState& ball, double t, double duration) {
  const Field& field = *model.field;
  const double speed = length(ball.velocity);
  double strongest = 0;
  for (const Well& well : field.wells)
    strongest += std::abs(well.strength) / (well.softening * well.softening);
  strongest *= 2 / (3 * std::sqrt(3.0));
  const double fastest =
      speed + (strongest + length(field.gravity)) * duration;  // m/s, drag only slows
  double bound = model.drag == 1 ? 0 : -naturalLogarithm(model.drag) * fastest;
  for (const Well& well : field.wells) {
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

}  // namespace

Path pathFrom(const PathModel& model, const BallState& state, double radius, double t) {
  Path path{state, t, radius, Motion::Flying};
  if (isHeldByGround(model, path)) holdOnGround(model, path);
  return path;
}

BallState stateAt(const PathModel& model, const Path& path, double t) {
  if (t <= path.start) return path.state;
  if (path.motion != Motion::Flying) return heldStateAt(model, path, t);
  BallState state = path.state;
  const std::uint32_t ball = 0;
  flyThrough(*model.integrator, {model.field, path.start, t - path.start, model.drag}, {&ball, 1},
             &state.position, &state.velocity);
  return state;
}

double accelerationBound(const PathModel& model, Motion motion, const BallState& now, double t,
                         double duration) {
  const double flight = flightBound(model, now, t, duration);
  if (motion == Motion::Flying) return flight;
  const Vec3& g = model.field->gravity;
  const double pull = flight + std::sqrt(g.x() * g.x() + g.z() * g.z());
  // Rolling takes 5/7 of the pull, sliding adds friction under the weight and the wells' pull.
  return motion == Motion::Rolling ? pull : pull + model.friction * (flight + std::abs(g.y()));
}

}  // namespace wells
