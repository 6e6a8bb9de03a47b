#include "contacts/path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/held_motion.h"
#include "contacts/support.h"
#include "forces/pull_bound.h"

namespace wells {
namespace {

/// A bound (m/s) on the speed of a ball, and on that of its surface by spin over
/// sqrt(kInertiaFactor), for `duration` seconds in which nothing pulls it by more than `strongest`
/// (m/s^2): friction may turn spin into speed, but adds no energy.
double fastest(const Path& path, const BallState& ball, double strongest, double duration) {
  double energy = squaredLength(ball.velocity);
  if (path.motion != Motion::Flying)
    energy += kInertiaFactor * path.radius * path.radius * squaredLength(ball.spin);
  return std::sqrt(energy) + strongest * duration;
}

/// By wells and drag.
double pullBoundOf(const PathModel& model, const Path& path, const BallState& ball, double t,
                   double duration) {
  const Field& field = *model.field;
  if (isParabola(field, model.drag)) return 0;
  double strongest = length(field.gravity);
  for (const WellBlock& block : field.wells.blocks())
    for (std::size_t k = 0; k < block.count; ++k) strongest += block.strongest[k];
  const double speed = fastest(path, ball, strongest, duration);  // drag only slows
  return dragRate(model.drag) * speed + pullBound(field, ball.position, speed, t, duration);
}

/// Friction over what presses, of a ball that turns or slides; rolling takes its share of the pull
/// besides.
double frictionBound(const PathModel& model, const Path& path) {
  return path.motion == Motion::Rolling ? (1 - kHolding) * model.rollingResistance / path.radius
                                        : model.friction;
}

/// On the ground: along it, where rolling takes 5/7 of the pull and friction comes under the weight
/// and the wells' pull.
double boundOnGround(const PathModel& model, const Path& path, double byFields) {
  const Vec3& g = model.field->gravity;
  const double friction = frictionBound(model, path);
  const double pull = byFields + std::sqrt(g.x() * g.x() + g.z() * g.z());
  return pull + friction * (byFields + std::abs(g.y()));
}

/// On the wall: the pull, the turning along it, and friction: of what presses, or of what rolling
/// needs (held_motion.h).
double boundOnWall(const PathModel& model, const Path& path, const BallState& ball, double byFields,
                   double duration) {
  const double pull = byFields + length(model.field->gravity);
  const double speed = fastest(path, ball, pull, duration);
  const double turning = speed * speed / (model.arena->radius - path.radius);
  const double slipPull = pull + turning / std::sqrt(kInertiaFactor);
  const double holding = path.motion == Motion::Rolling ? slipPull / kSlipRatio : 0;
  return pull + turning + (holding + frictionBound(model, path) * (pull + turning));
}

/// In the corner: the pull, the turning, and friction on both. Each presses with what it would
/// without friction and at most the friction of the other.
double boundInCorner(const PathModel& model, const Path& path, const BallState& ball,
                     double byFields, double duration) {
  const double pull = byFields + length(model.field->gravity);
  const double speed = fastest(path, ball, pull, duration);
  const double turning = speed * speed / (model.arena->radius - path.radius);
  const double mu = model.friction;
  return pull + turning + mu * (1 + mu) * (2 * pull + turning);
}

}  // namespace

Path pathFrom(const PathModel& model, const BallState& state, double radius, double t) {
  Path path{state, t, radius, Motion::Flying, kNoSurface};
  path.surface = holderOf(model, path);
  if (path.surface != kNoSurface) holdOn(model, path);
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

std::pair<BallState, BallState> statesAt(const PathModel& model, const Path& a, const Path& b,
                                         double t) {
  const bool flyTogether = a.motion == Motion::Flying && b.motion == Motion::Flying &&
                           a.start == b.start && a.start < t &&
                           !isParabola(*model.field, model.drag);
  if (!flyTogether) return {stateAt(model, a, t), stateAt(model, b, t)};
  std::array<double, 2> x[3];  // m
  std::array<double, 2> v[3];  // m/s
  for (int k = 0; k < 3; ++k) {
    x[k] = {a.state.position[k], b.state.position[k]};
    v[k] = {a.state.velocity[k], b.state.velocity[k]};
  }
  flyThrough(*model.integrator, {model.field, a.start, t - a.start, model.drag},
             {x[0].data(), x[1].data(), x[2].data(), v[0].data(), v[1].data(), v[2].data(), 2});
  const auto end = [&](std::size_t i, const Vec3& spin) {
    return BallState{{x[0][i], x[1][i], x[2][i]}, {v[0][i], v[1][i], v[2][i]}, spin};
  };
  return {end(0, a.state.spin), end(1, b.state.spin)};
}

void endFlights(const PathModel& model, std::span<const Path> paths,
                std::span<const std::uint32_t> place, double t, std::span<std::uint32_t> flying,
                Balls& balls) {
  const auto startOf = [&](std::uint32_t i) { return paths[place[i]].start; };
  if (!std::ranges::is_sorted(flying, {}, startOf)) std::ranges::sort(flying, {}, startOf);
  for (const std::uint32_t i : flying) balls.setState(i, paths[place[i]].state);
  while (!flying.empty()) {
    const double start = startOf(flying.front());
    const auto next = std::ranges::find_if(flying, [&](auto i) { return startOf(i) != start; });
    const auto count = static_cast<std::size_t>(next - flying.begin());
    flyThrough(*model.integrator, {model.field, start, t - start, model.drag}, flying.first(count),
               balls.position.data(), balls.velocity.data());
    flying = flying.subspan(count);
  }
}

double accelerationBound(const PathModel& model, const Path& path, const BallState& now, double t,
                         double duration) {
  if (path.motion == Motion::Resting) return 0;
  const double byFields = pullBoundOf(model, path, now, t, duration);
  if (path.motion == Motion::Flying) return byFields;
  if (path.surface == kCorner) return boundInCorner(model, path, now, byFields, duration);
  return path.surface == kGround ? boundOnGround(model, path, byFields)
                                 : boundOnWall(model, path, now, byFields, duration);
}

double approachBound(const PathModel& model, const Path& pathA, const BallState& a,
                     const Path& pathB, const BallState& b, double t, double duration) {
  // Gravity is the same for both, unless a surface takes it from one.
  const bool same = (pathA.motion == Motion::Flying) == (pathB.motion == Motion::Flying);
  return (same ? 0 : length(model.field->gravity)) +
         accelerationBound(model, pathA, a, t, duration) +
         accelerationBound(model, pathB, b, t, duration);
}

}  // namespace wells
