#include "contacts/held_motion.h"

#include <algorithm>
#include <limits>

namespace wells {
namespace {

constexpr double kHolding = 1 / kSlipRatio;  // friction that rolling takes over the slip's pull
constexpr double kSlipNoise = 1e-10;

Surface surfaceOf(const PathModel& model, const Path& path) {
  return {*model.arena, path.surface, path.state.position, path.radius};
}

bool isZero(Flat a) {
  return a.x == 0 && a.y == 0;
}

}  // namespace

struct HeldMotion::Rate {
  Flat velocity, pull, slip;
  double spin = 0;
};

HeldMotion::HeldMotion(const PathModel& model, const Path& path)
    : model_(model), path_(path), surface_(surfaceOf(model, path)), drag_(dragRate(model.drag)) {
  const Frame frame = surface_.at({}).frame;
  const BallState& ball = path.state;
  start_ = {
      {}, frame.flat(ball.velocity), frame.flat(slipOf(model, path)), dot(ball.spin, frame.normal)};
  // Nothing turns a slip but a pull, or on the wall a spin that the frame carries round.
  const Field& field = *model.field;
  isPulled_ = !field.wells.empty() || drag_ > 0;
  if (surface_.curvature() == 0)
    isPulled_ = isPulled_ || !isZero(frame.flat(field.gravity));
  else
    isPulled_ = isPulled_ || squaredLength(field.gravity) > 0 || start_.spin != 0 ||
                start_.velocity.y != start_.slip.y;
  if (path.motion != Motion::Sliding) return;
  noise_ = slipNoise(ball, path.radius);
  const Flat along =
      length(start_.slip) > noise_ ? start_.slip : loadOn(start_, path.start).slipPull;
  const double total = length(along);
  if (total > 0) first_ = (1 / total) * along;
}

Load HeldMotion::loadOn(const Held& now, double t) const {
  const Surface::Spot spot = surface_.at(now.place);
  const Vec3 a = acceleration(*model_.field, spot.center, t);
  const double turning = surface_.curvature() * now.velocity.x;  // rad/s
  const Flat pull = spot.frame.flat(a) - drag_ * now.velocity;
  return {pull, pull + Flat{0, path_.radius * turning * now.spin},
          turning * now.velocity.x - dot(a, spot.frame.normal)};
}

BallState HeldMotion::ballOf(const Held& now) const {
  const Surface::Spot spot = surface_.at(now.place);
  BallState ball{spot.center, spot.frame.vector(now.velocity), path_.state.spin};
  if (model_.friction == 0) return ball;  // nothing turns it
  const Flat slip = path_.motion == Motion::Rolling ? Flat{} : now.slip;
  const Flat lag = (1 / path_.radius) * (now.velocity - slip);
  ball.spin = now.spin * spot.frame.normal + lag.x * spot.frame.y - lag.y * spot.frame.x;
  return ball;
}

bool HeldMotion::isEndless() const {
  const Field& field = *model_.field;
  const bool onlySlides = model_.friction == 0;
  if (!field.wells.empty()) return false;
  if (surface_.curvature() > 0) return onlySlides && squaredLength(field.gravity) == 0;
  return isZero(surface_.at({}).frame.flat(field.gravity)) &&
         (onlySlides || path_.motion == Motion::Rolling);
}

double HeldMotion::longestStep(const Held& now, double t) const {
  double whole = model_.field->stretch;
  const double turning = surface_.curvature() * std::abs(now.velocity.x);
  if (turning > 0) whole = std::min(whole, kLongestArc / turning);
  const double slip = length(now.slip);
  if (path_.motion != Motion::Sliding || !isPulled_ || slip <= noise_) return whole;
  const Load load = loadOn(now, t);
  const double friction = frictionOnSlip(load);
  // A slip that ends turns ever faster towards the pull: ever shorter steps, as it gets smaller.
  if (dot(load.slipPull, now.slip) < friction * slip)
    return std::min(whole, std::max(kShortestStep * whole, kTurningShare * slip / friction));
  // One that begins is held to the pull's direction, stiffly: within what RK4 keeps stable.
  return slip <= smallSlip(friction)
             ? whole
             : std::min(whole, std::max(kShortestStep * whole, slip / friction));
}

double HeldMotion::continuation(const Held& now, double t) const {
  const Load load = loadOn(now, t);
  // Whichever is nearer to its end, in m/s^2 of the force that it lacks.
  if (path_.motion == Motion::Rolling)
    return std::min(load.pressing,
                    model_.friction * load.pressing - kHolding * length(load.slipPull));
  if (model_.friction == 0) return load.pressing;
  return std::min(load.pressing, dot(now.slip, first_));
}

// Friction never turns past a right angle from the direction in which it began: what slips the
// other way has begun to roll before, and only the search for that time asks.
Flat HeldMotion::direction(Flat slip, const Load& load) const {
  if (!isPulled_) return first_;
  const double size = length(slip);
  const double friction = frictionOnSlip(load);
  if (size <= smallSlip(friction) && dot(load.slipPull, first_) > friction)
    return (1 / length(load.slipPull)) * load.slipPull;
  if (dot(slip, first_) <= noise_) return first_;
  return (1 / size) * slip;
}

/// m/s^2, by which friction alone would end a slip. None where the ball has lifted off, which the
/// search for that time looks beyond.
double HeldMotion::frictionOnSlip(const Load& load) const {
  return kSlipRatio * model_.friction * std::max(0.0, load.pressing);
}

/// m/s; a slip that begins and is smaller follows the pull.
double HeldMotion::smallSlip(double friction) const {
  return kFollowingShare * friction * model_.field->stretch;
}

HeldMotion::Rate HeldMotion::rateOf(const Held& now, double t) const {
  const Load load = loadOn(now, t);
  const bool isRolling = path_.motion == Motion::Rolling;
  const Flat friction = isRolling ? -kHolding * load.slipPull
                                  : -frictionOnSlip(load) / kSlipRatio * direction(now.slip, load);
  const double lag = (now.velocity.y - now.slip.y) / path_.radius;
  return {now.velocity, load.pull + friction,
          isRolling ? Flat{} : load.slipPull + kSlipRatio * friction,
          surface_.curvature() * now.velocity.x * lag};
}

Held HeldMotion::step(const Held& y, double t, double h) const {
  const auto moved = [&](const Rate& r, double s) -> Held {
    return {y.place + s * r.velocity, y.velocity + s * r.pull, y.slip + s * r.slip,
            y.spin + s * r.spin};
  };
  const auto sum = [](auto a, auto b, auto c, auto d) { return a + 2 * (b + c) + d; };
  const Rate a = rateOf(y, t);
  const Rate b = rateOf(moved(a, h / 2), t + h / 2);
  const Rate c = rateOf(moved(b, h / 2), t + h / 2);
  const Rate d = rateOf(moved(c, h), t + h);
  return {y.place + (h / 6) * sum(a.velocity, b.velocity, c.velocity, d.velocity),
          y.velocity + (h / 6) * sum(a.pull, b.pull, c.pull, d.pull),
          y.slip + (h / 6) * sum(a.slip, b.slip, c.slip, d.slip),
          y.spin + (h / 6) * sum(a.spin, b.spin, c.spin, d.spin)};
}

Load loadOn(const PathModel& model, const Path& path, double t) {
  const HeldMotion motion(model, path);
  return motion.loadOn(motion.start(), t);
}

bool canRoll(const PathModel& model, const Load& load) {
  return kHolding * length(load.slipPull) <= model.friction * load.pressing;
}

Vec3 normalOf(const PathModel& model, const Path& path) {
  return surfaceOf(model, path).at({}).frame.normal;
}

Vec3 slipOf(const PathModel& model, const Path& path) {
  return path.state.velocity - path.radius * cross(path.state.spin, normalOf(model, path));
}

double slipNoise(const BallState& ball, double radius) {
  return kSlipNoise * (length(ball.velocity) + radius * length(ball.spin));
}

}  // namespace wells
