#include "contacts/held_motion.h"

#include <algorithm>
#include <limits>

namespace wells {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSlipNoise = 1e-10;

Surface surfaceOf(const PathModel& model, const Path& path) {
  return {*model.arena, path.surface, path.state.position, path.radius};
}

bool isZero(Flat a) {
  return a.x == 0 && a.y == 0;
}

/// Zero of zero.
Flat directionOf(Flat a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : Flat{};
}

}  // namespace

struct HeldMotion::Rate {
  Flat velocity, pull, slip;
  double spin = 0;
};

HeldMotion::HeldMotion(const PathModel& model, const Path& path)
    : model_(model),
      path_(path),
      surface_(surfaceOf(model, path)),
      drag_(dragRate(model.drag)),
      resistance_(model.rollingResistance / path.radius) {
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
  const bool slides = path.motion == Motion::Sliding;
  // Or rolling resistance, and friction the turning that it meets.
  if (slides && resistance_ > 0) isPulled_ = true;
  if (slides || path.motion == Motion::Skidding) beginSlip();
  if (resistance_ > 0 && (slides || path.motion == Motion::Rolling)) beginTurning();
}

double HeldMotion::noise() const {
  double noise = slipNoise(path_.state, path_.radius);
  if (resistance_ > 0)
    noise += kSlipNoise * (model_.friction + resistance_) *
             std::max(0.0, loadOn(start_, path_.start).pressing) * model_.field->stretch;
  return noise;
}

void HeldMotion::beginSlip() {
  slip_.noise = noise();
  Flat along = start_.slip;
  if (length(along) <= slip_.noise) {
    const Load load = loadOn(start_, path_.start);
    along = path_.motion == Motion::Skidding ? load.pull : load.slipPull;
    const Flat lag = lagOf(start_);
    if (resistance_ > 0 && length(lag) > slip_.noise)  // it rolled until now
      along = along + resistanceOnTurning(load) / length(lag) * lag;
  }
  slip_.first = directionOf(along);
}

void HeldMotion::beginTurning() {
  const Load load = loadOn(start_, path_.start);
  turning_.noise = noise();
  const Flat lag = lagOf(start_);
  const Flat friction = -model_.friction * std::max(0.0, load.pressing) * slip_.first;
  turning_.first =
      directionOf(length(lag) > turning_.noise ? lag : driveOfTurning(load, friction).pull);
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
  if (model_.friction == 0 && resistance_ == 0) return ball;  // nothing turns it
  const Flat lag = (1 / path_.radius) * lagOf(now);
  ball.spin = now.spin * spot.frame.normal + lag.x * spot.frame.y - lag.y * spot.frame.x;
  return ball;
}

Flat HeldMotion::lagOf(const Held& now) const {
  if (path_.motion == Motion::Skidding) return {};
  return now.velocity - (path_.motion == Motion::Rolling ? Flat{} : now.slip);
}

bool HeldMotion::isEndless() const {
  const Field& field = *model_.field;
  const bool onlySlides = model_.friction == 0;
  if (!field.wells.empty()) return false;
  if (resistance_ > 0) return path_.motion == Motion::Resting;
  if (surface_.curvature() > 0) return onlySlides && squaredLength(field.gravity) == 0;
  return isZero(surface_.at({}).frame.flat(field.gravity)) &&
         (onlySlides || path_.motion == Motion::Rolling);
}

double HeldMotion::longestStep(const Held& now, double t) const {
  double whole = model_.field->stretch;
  const double turning = surface_.curvature() * std::abs(now.velocity.x);
  if (turning > 0) whole = std::min(whole, kLongestArc / turning);
  const bool isRolling = path_.motion == Motion::Rolling;
  if (!isPulled_ || path_.motion == Motion::Resting || (isRolling && resistance_ == 0))
    return whole;
  const Load load = loadOn(now, t);
  double longest = whole;
  if (!isRolling) longest = longestStep(now.slip, driveOfSlip(now, load), slip_, whole);
  if (resistance_ == 0 || path_.motion == Motion::Skidding) return longest;
  const Drive drive = driveOfTurning(load, isRolling ? Flat{} : gripOn(now, load).friction);
  return std::min(longest, longestStep(lagOf(now), drive, turning_, whole));
}

double HeldMotion::longestStep(Flat moving, const Drive& drive, const Opposed& opposed,
                               double whole) const {
  const double speed = length(moving);
  if (speed <= opposed.noise || follows(speed, drive, opposed)) return whole;
  // What ends turns ever faster towards the pull: ever shorter steps, as it gets smaller.
  if (dot(drive.pull, moving) < drive.limit * speed)
    return std::min(whole, std::max(kShortestPart * whole, kTurningShare * speed / drive.limit));
  // What begins is held to the pull's direction, stiffly: within what RK4 keeps stable.
  return std::min(whole, std::max(kShortestPart * whole, speed / drive.limit));
}

double HeldMotion::continuation(const Held& now, double t) const {
  const Load load = loadOn(now, t);
  // Whichever is nearer to its end, in m/s^2 of the force that it lacks.
  return std::min({load.pressing, reserve(now, load), remainder(now)});
}

bool HeldMotion::isOverpowered(const Held& now, double t) const {
  return reserve(now, loadOn(now, t)) < remainder(now);
}

/// m/s^2 that friction, or rolling resistance, could hold beyond what it does.
double HeldMotion::reserve(const Held& now, const Load& load) const {
  const double friction = model_.friction * load.pressing;
  switch (path_.motion) {
    case Motion::Rolling:
      return friction - kHolding * length(load.slipPull + gripOn(now, load).resistance);
    case Motion::Skidding:
      // On the ground nothing but friction turns it, which never varies beside the resistance.
      if (surface_.curvature() == 0) break;
      return resistanceOnTurning(load) -
             length(driveOfTurning(load, gripOn(now, load).friction).pull);
    case Motion::Resting:
      return std::min(friction, resistance_ * load.pressing) - length(load.pull);
    default:
      break;
  }
  return kNever;
}

/// m/s of a slip or a turning, in the direction in which it began.
double HeldMotion::remainder(const Held& now) const {
  const bool isRolling = path_.motion == Motion::Rolling;
  double least = kNever;
  if (path_.motion == Motion::Resting) return least;
  if (!isRolling && model_.friction > 0) least = dot(now.slip, slip_.first);
  if (resistance_ > 0 && path_.motion != Motion::Skidding)
    least = std::min(least, dot(lagOf(now), turning_.first));
  return least;
}

// Friction never turns past a right angle from the direction in which it began: what slips the
// other way has begun to roll before, and only the search for that time asks.
Flat HeldMotion::direction(Flat moving, const Drive& drive, const Opposed& opposed) const {
  if (!isPulled_) return opposed.first;
  const double speed = length(moving);
  if (follows(speed, drive, opposed)) return (1 / length(drive.pull)) * drive.pull;
  if (dot(moving, opposed.first) <= opposed.noise) return opposed.first;
  return (1 / speed) * moving;
}

// The limits are m/s^2, by which friction or resistance alone would end a slip or a turning. None
// where the ball has lifted off, which the search for that time looks beyond.

HeldMotion::Drive HeldMotion::driveOfSlip(const Held& now, const Load& load) const {
  const double pressing = std::max(0.0, load.pressing);
  if (path_.motion == Motion::Skidding) return {load.pull, model_.friction * pressing};
  const double friction = kSlipRatio * model_.friction * pressing;
  if (resistance_ == 0) return {load.slipPull, friction};
  const Flat lag = lagOf(now);
  const Flat turning =
      dot(lag, turning_.first) <= turning_.noise ? turning_.first : (1 / length(lag)) * lag;
  return {load.slipPull + resistanceOnTurning(load) * turning, friction};
}

HeldMotion::Drive HeldMotion::driveOfTurning(const Load& load, Flat friction) const {
  const double resistance = resistanceOnTurning(load);
  if (path_.motion == Motion::Rolling)
    return {load.pull - kHolding * load.slipPull, kHolding * resistance};
  return {load.pull - load.slipPull - kSpinning * friction, resistance};
}

double HeldMotion::resistanceOnTurning(const Load& load) const {
  return kSpinning * resistance_ * std::max(0.0, load.pressing);
}

/// What is small and pulled on turns to the pull at once: at the rate pull / speed, whether it
/// begins or ends.
bool HeldMotion::follows(double speed, const Drive& drive, const Opposed& opposed) const {
  return speed <= smallest(drive.limit) && dot(drive.pull, opposed.first) > drive.limit / 2;
}

/// m/s; what is smaller may follow the pull.
double HeldMotion::smallest(double limit) const {
  return kFollowingShare * limit * model_.field->stretch;
}

HeldMotion::Grip HeldMotion::gripOn(const Held& now, const Load& load) const {
  if (path_.motion == Motion::Rolling) {
    if (resistance_ == 0) return {-kHolding * load.slipPull, {}};
    const Flat resistance =
        resistanceOnTurning(load) * direction(now.velocity, driveOfTurning(load, {}), turning_);
    return {-kHolding * (load.slipPull + resistance), resistance};
  }
  const Drive slip = driveOfSlip(now, load);
  const double ratio = path_.motion == Motion::Skidding ? 1 : kSlipRatio;
  const Flat friction = -slip.limit / ratio * direction(now.slip, slip, slip_);
  if (resistance_ == 0 || path_.motion == Motion::Skidding) return {friction, {}};
  const Drive turning = driveOfTurning(load, friction);
  return {friction, turning.limit * direction(lagOf(now), turning, turning_)};
}

HeldMotion::Rate HeldMotion::rateOf(const Held& now, double t) const {
  if (path_.motion == Motion::Resting) return {};
  const Load load = loadOn(now, t);
  const Grip grip = gripOn(now, load);
  Rate rate{now.velocity, load.pull + grip.friction, {}, 0};
  if (path_.motion == Motion::Skidding) {
    rate.slip = rate.pull;
    return rate;
  }
  if (path_.motion == Motion::Sliding) {
    rate.slip = load.slipPull + kSlipRatio * grip.friction;
    if (resistance_ > 0) rate.slip = rate.slip + grip.resistance;
  }
  const double lag = (now.velocity.y - now.slip.y) / path_.radius;
  rate.spin = surface_.curvature() * now.velocity.x * lag;
  return rate;
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
