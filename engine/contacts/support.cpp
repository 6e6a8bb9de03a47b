#include "contacts/support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

constexpr double kSlipRatio = 1 + 1 / kInertiaFactor;  // du/dt over dv/dt of friction, 7/2
constexpr double kRolling = 1 / (1 + kInertiaFactor);  // dv/dt of a rolling ball over the pull, 5/7
constexpr double kHolding = 1 - kRolling;              // friction that rolling takes over the pull
// A slip this small, of the speeds that it is made of, is over. (A slip that turns on its way to
// zero is followed there in ever shorter stretches, which this ends.)
constexpr double kSlipNoise = 1e-10;
constexpr double kTurningShare = 1.0 / 8;      // of the time in which friction ends a slip
constexpr double kFollowingShare = 1.0 / 256;  // of the slip that friction ends in a stretch
constexpr double kShortestStep = 1.0 / 256;    // of a stretch: bounds the work

// A gap this small, of the size of the coordinates, is none for a ball that does not move up or
// down: flight in many stretches leaves it so.
constexpr double kHeldGap = 1e-13;

constexpr double kBeginning = 1.0 / 64;  // of a stretch, after which a slip must have begun

/// A vector in the ground's plane.
struct Flat {
  double x = 0;
  double z = 0;
};

Flat operator+(Flat a, Flat b) {
  return {a.x + b.x, a.z + b.z};
}
Flat operator-(Flat a, Flat b) {
  return {a.x - b.x, a.z - b.z};
}
Flat operator*(double s, Flat a) {
  return {s * a.x, s * a.z};
}
double dot(Flat a, Flat b) {
  return a.x * b.x + a.z * b.z;
}
double length(Flat a) {
  return std::sqrt(dot(a, a));
}
Flat flat(const Vec3& a) {
  return {a.x(), a.z()};
}

Flat slipOf(const BallState& ball, double radius) {
  return flat(slipOnGround(ball, radius));
}

/// The spin that makes the slip `slip`; that about the normal stays.
void setSlip(BallState& ball, double radius, Flat slip) {
  ball.spin.z() = (slip.x - ball.velocity.x()) / radius;
  ball.spin.x() = (ball.velocity.z() - slip.z) / radius;
}

double slipNoise(const BallState& ball, double radius) {
  return kSlipNoise * (wells::length(ball.velocity) + radius * wells::length(ball.spin));
}

/// Forces per mass on a ball held by the ground.
struct Load {
  Flat pull;            // along the ground
  double pressing = 0;  // into it
};

Load loadAt(const PathModel& model, double height, Flat place, Flat velocity, double k, double t) {
  const Vec3 a = acceleration(*model.field, {place.x, height, place.z}, t);
  return {flat(a) - k * velocity, -a.y()};
}

Load loadOn(const PathModel& model, const BallState& ball, double t) {
  return loadAt(model, ball.position.y(), flat(ball.position), flat(ball.velocity),
                dragRate(model.drag), t);
}

bool canRoll(const PathModel& model, const Load& load) {
  return kHolding * length(load.pull) <= model.friction * load.pressing;
}

struct Held {
  Flat place, velocity, slip;
};

Held heldAtStart(const Path& path) {
  return {flat(path.state.position), flat(path.state.velocity), slipOf(path.state, path.radius)};
}

struct Rate {
  Flat velocity, pull, slip;
};

/// The right-hand side. Friction never turns past a right angle from the direction in which it
/// began: what slips the other way has begun to roll before, and only the search for that time
/// asks.
class Rates {
 public:
  Rates(const PathModel& model, const Path& path)
      : model_(model),
        motion_(path.motion),
        height_(path.state.position.y()),
        k_(dragRate(model.drag)) {
    if (motion_ != Motion::Sliding) return;
    const Flat slip = slipOf(path.state, path.radius);
    const double size = length(slip);
    noise_ = slipNoise(path.state, path.radius);
    const Flat along = size > noise_ ? slip : loadOn(model, path.state, path.start).pull;
    const double total = length(along);
    if (total > 0) first_ = (1 / total) * along;
    // Nothing turns a slip but a pull.
    turns_ = !model.field->wells.empty() || k_ > 0 || length(flat(model.field->gravity)) > 0;
  }

  /// The longest step (s) in which friction keeps its direction well enough.
  double longestStep(const Held& now, double t) const {
    const double whole = model_.field->stretch;
    const double slip = length(now.slip);
    if (motion_ != Motion::Sliding || !turns_ || slip <= noise_) return whole;
    const Load load = loadAt(model_, height_, now.place, now.velocity, k_, t);
    const double friction = frictionOnSlip(load);
    // A slip that ends turns ever faster towards the pull: ever shorter steps, as it gets smaller.
    if (dot(load.pull, now.slip) < friction * slip)
      return std::min(whole, std::max(kShortestStep * whole, kTurningShare * slip / friction));
    // One that begins is held to the pull's direction, stiffly: within what RK4 keeps stable.
    return slip <= smallSlip(friction)
               ? whole
               : std::min(whole, std::max(kShortestStep * whole, slip / friction));
  }

  /// > 0 while the motion goes on; <= 0 where it has ended.
  double continuation(const Held& now, double t) const {
    const Load load = loadAt(model_, height_, now.place, now.velocity, k_, t);
    // Whichever is nearer to its end, in m/s^2 of the force that it lacks.
    if (motion_ == Motion::Rolling)
      return std::min(load.pressing,
                      model_.friction * load.pressing - kHolding * length(load.pull));
    if (model_.friction == 0) return load.pressing;
    return std::min(load.pressing, dot(now.slip, first_));
  }

  Rate operator()(const Held& now, double t) const {
    const Load load = loadAt(model_, height_, now.place, now.velocity, k_, t);
    if (motion_ == Motion::Rolling) return {now.velocity, kRolling * load.pull, {}};
    const Flat friction = (-frictionOnSlip(load) / kSlipRatio) * direction(now.slip, load);
    return {now.velocity, load.pull + friction, load.pull + kSlipRatio * friction};
  }

 private:
  /// m/s^2, by which friction alone would end a slip. None where the ball has lifted off, which the
  /// search for that time looks beyond.
  double frictionOnSlip(const Load& load) const {
    return kSlipRatio * model_.friction * std::max(0.0, load.pressing);
  }

  /// m/s; a slip that begins and is smaller follows the pull.
  double smallSlip(double friction) const {
    return kFollowingShare * friction * model_.field->stretch;
  }

  Flat direction(Flat slip, const Load& load) const {
    if (!turns_) return first_;
    const double size = length(slip);
    const double friction = frictionOnSlip(load);
    if (size <= smallSlip(friction) && dot(load.pull, first_) > friction)
      return (1 / length(load.pull)) * load.pull;
    if (dot(slip, first_) <= noise_) return first_;
    return (1 / size) * slip;
  }

  const PathModel& model_;
  Motion motion_;
  double height_;
  double k_;
  double noise_ = 0;
  bool turns_ = false;
  Flat first_;
};

Held step(const Rates& rates, const Held& y, double t, double h) {
  const auto moved = [&](const Rate& r, double s) -> Held {
    return {y.place + s * r.velocity, y.velocity + s * r.pull, y.slip + s * r.slip};
  };
  const auto sum = [](Flat a, Flat b, Flat c, Flat d) { return a + 2 * (b + c) + d; };
  const Rate a = rates(y, t);
  const Rate b = rates(moved(a, h / 2), t + h / 2);
  const Rate c = rates(moved(b, h / 2), t + h / 2);
  const Rate d = rates(moved(c, h), t + h);
  return {y.place + (h / 6) * sum(a.velocity, b.velocity, c.velocity, d.velocity),
          y.velocity + (h / 6) * sum(a.pull, b.pull, c.pull, d.pull),
          y.slip + (h / 6) * sum(a.slip, b.slip, c.slip, d.slip)};
}

/// The first sign change of f from > 0 at `low` to <= 0 at `high`: false position, kept safe by
/// bisection (Illinois: Dowell & Jarratt, BIT 11 (1971) 168). Returns the side where f <= 0.
template <class F>
double zeroOf(F f, double low, double atLow, double high, double atHigh) {
  double lowWeight = atLow;
  double highWeight = atHigh;
  for (int look = 0; look < 200; ++look) {
    double t = look % 4 == 3 ? low + (high - low) / 2
                             : low + (high - low) * (lowWeight / (lowWeight - highWeight));
    if (!(t > low && t < high)) t = low + (high - low) / 2;
    if (!(t > low && t < high)) break;
    const double value = f(t);
    if (value > 0) {
      low = t;
      lowWeight = value;
      highWeight /= 2;
    } else {
      high = t;
      highWeight = value;
      lowWeight /= 2;
      if (value == 0) break;
    }
  }
  return high;
}

}  // namespace

Vec3 slipOnGround(const BallState& ball, double radius) {
  return {ball.velocity.x() + radius * ball.spin.z(), 0,
          ball.velocity.z() - radius * ball.spin.x()};
}

bool isHeldByGround(const PathModel& model, const Path& path) {
  const BallState& ball = path.state;
  const Arena& arena = *model.arena;
  const double size = std::abs(arena.center.y()) + std::abs(ball.position.y()) + path.radius;
  if (std::abs(groundGap(arena, ball.position, path.radius)) > kHeldGap * size) return false;
  if (withoutNoise(ball.velocity.y(), wells::length(ball.velocity)) != 0) return false;
  return loadOn(model, ball, path.start).pressing > 0;
}

void holdOnGround(const PathModel& model, Path& path) {
  BallState& ball = path.state;
  ball.position.y() = model.arena->center.y() + path.radius;
  ball.velocity.y() = 0;
  const Flat slip = slipOf(ball, path.radius);
  if (model.friction == 0 || length(slip) > slipNoise(ball, path.radius) ||
      !canRoll(model, loadOn(model, ball, path.start))) {
    path.motion = Motion::Sliding;
    return;
  }
  // The last of the slip goes by the impulse that stops it.
  path.motion = Motion::Rolling;
  ball.velocity.x() -= slip.x / kSlipRatio;
  ball.velocity.z() -= slip.z / kSlipRatio;
  setSlip(ball, path.radius, {});
}

BallState heldStateAt(const PathModel& model, const Path& path, double t) {
  const Rates rates(model, path);
  Held now = heldAtStart(path);
  double left = t - path.start;
  double at = path.start;
  while (left > 0) {
    const double h = std::min(left, rates.longestStep(now, at));
    now = step(rates, now, at, h);
    at += h;
    left -= h;
  }
  BallState ball = path.state;
  ball.position.x() = now.place.x;
  ball.position.z() = now.place.z;
  ball.velocity.x() = now.velocity.x;
  ball.velocity.z() = now.velocity.z;
  if (path.motion == Motion::Rolling)
    setSlip(ball, path.radius, {});
  else if (model.friction > 0)
    setSlip(ball, path.radius, now.slip);
  return ball;
}

double endOfMotion(const PathModel& model, const Path& path, double until) {
  // Without wells the load stays, and only friction on a slip ends anything.
  const bool isSteady = model.field->wells.empty() && length(flat(model.field->gravity)) == 0;
  if (isSteady && (path.motion == Motion::Rolling || model.friction == 0))
    return std::numeric_limits<double>::infinity();
  const Rates rates(model, path);
  Held low = heldAtStart(path);
  double at = path.start;
  double atLow = rates.continuation(low, at);
  // A slip that begins has none at first.
  const double watched = atLow > 0 ? at : at + kBeginning * model.field->stretch;
  while (at < until) {
    const double most = rates.longestStep(low, at);
    const double next = until - at > most ? at + most : until;
    const Held high = step(rates, low, at, next - at);
    const double atHigh = rates.continuation(high, next);
    if (atHigh <= 0 && atLow > 0 && next > watched) {
      const auto f = [&](double t) { return rates.continuation(step(rates, low, at, t - at), t); };
      return zeroOf(f, at, atLow, next, atHigh);
    }
    low = high;
    at = next;
    atLow = atHigh;
  }
  return std::numeric_limits<double>::infinity();
}

Path pathAfter(const PathModel& model, const Path& path, double end) {
  Path next{stateAt(model, path, end), end, path.radius, Motion::Flying};
  if (loadOn(model, next.state, end).pressing > 0) holdOnGround(model, next);
  return next;
}

}  // namespace wells
