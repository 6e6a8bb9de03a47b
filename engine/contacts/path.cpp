#include "contacts/path.h"

#include <algorithm>
#include <cmath>

#include "contacts/support.h"

namespace wells {
namespace {

/// m/s^2, the strongest pull of a well: at softening / sqrt(2) from it.
double strongestPull(const Well& well) {
  return 2 / (3 * std::sqrt(3.0)) * std::abs(well.strength) / (well.softening * well.softening);
}

/// By wells and drag. `friction`: Coulomb's coefficient where the ball slides, else 0.
double pullBound(const PathModel& model, double friction, const BallState& ball, double t,
                 double duration) {
  const Field& field = *model.field;
  double strongest = length(field.gravity);
  for (const Well& well : field.wells) strongest += strongestPull(well);
  const double fastest =
      length(ball.velocity) + (1 + friction) * strongest * duration;  // m/s, drag only slows
  double bound = dragRate(model.drag) * fastest;
  for (const Well& well : field.wells) {
    const Vec3 d = well.position + well.velocity * t - ball.position;
    const double e2 = well.softening * well.softening;
    const double s2 = squaredLength(d) + e2;
    const double now = std::abs(well.strength) * length(d) / (s2 * std::sqrt(s2));
    const double steepness = std::abs(well.strength) / (e2 * well.softening);
    bound += std::min(strongestPull(well),
                      now + steepness * (fastest + length(well.velocity)) * duration);
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
  const double friction = motion == Motion::Sliding ? model.friction : 0;
  const double byFields = pullBound(model, friction, now, t, duration);
  if (motion == Motion::Flying) return byFields;
  const Vec3& g = model.field->gravity;
  const double pull = byFields + std::sqrt(g.x() * g.x() + g.z() * g.z());
  // Rolling takes 5/7 of the pull, sliding adds friction under the weight and the wells' pull.
  return pull + friction * (byFields + std::abs(g.y()));
}

double approachBound(const PathModel& model, Motion motionA, const BallState& a, Motion motionB,
                     const BallState& b, double t, double duration) {
  // Gravity is the same for both, unless the ground takes it from one.
  const bool same = (motionA == Motion::Flying) == (motionB == Motion::Flying);
  return (same ? 0 : length(model.field->gravity)) +
         accelerationBound(model, motionA, a, t, duration) +
         accelerationBound(model, motionB, b, t, duration);
}

}  // namespace wells
