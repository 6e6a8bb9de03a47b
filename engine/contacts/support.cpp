#include "contacts/support.h"

#include <cmath>
#include <limits>

#include "contacts/held_motion.h"
#include "contacts/motion_choice.h"

namespace wells {
namespace {

// A gap this small, of the size of the coordinates, is none for a ball that moves neither to nor
// from the surface: flight in many stretches leaves it so.
constexpr double kHeldGap = 1e-13;

constexpr double kBeginning = 1.0 / 64;  // of a stretch, after which a slip must have begun

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

/// True where the ball of a flying path touches the surface at path.start, neither leaves nor
/// approaches it, and is pressed to it.
bool isHeldBy(const PathModel& model, const Path& path) {
  const BallState& ball = path.state;
  const Arena& arena = *model.arena;
  const bool isGround = path.surface == kGround;
  const double gap = isGround ? groundGap(arena, ball.position, path.radius)
                              : wallGap(arena, ball.position, path.radius);
  const double size = isGround
                          ? std::abs(arena.center.y()) + std::abs(ball.position.y()) + path.radius
                          : std::abs(arena.center.x()) + std::abs(arena.center.z()) + arena.radius;
  if (!(std::abs(gap) <= kHeldGap * size)) return false;
  const Vec3 normal = normalOf(model, path);
  // The wall's normal is as good as the coordinates that it is made of.
  const double noise = isGround ? 1 : 1 + size / arena.radius;
  if (withoutNoise(dot(ball.velocity, normal), noise * length(ball.velocity)) != 0) return false;
  return loadOn(model, path, path.start).pressing > 0;
}

Held heldAt(const HeldMotion& motion, const Path& path, double t) {
  Held now = motion.start();
  double left = t - path.start;
  double at = path.start;
  while (left > 0) {
    const double h = std::min(left, motion.longestStep(now, at));
    now = motion.step(now, at, h);
    at += h;
    left -= h;
  }
  return now;
}

bool hasLostGrip(const PathModel& model, const Path& path, double end) {
  if (model.rollingResistance == 0) return path.motion == Motion::Rolling;
  const HeldMotion motion(model, path);
  return motion.isOverpowered(heldAt(motion, path, end), end);
}

void begin(Motion motion, const PathModel& model, Held held, Path& path) {
  path.motion = motion;
  // What has rested before keeps its bits.
  if (motion == Motion::Resting && path.state.velocity.isZero(0)) return;
  // The last of the slip, or of the turning, goes by the impulse that stops it.
  if (motion == Motion::Rolling) held.velocity = held.velocity - (1 / kSlipRatio) * held.slip;
  if (motion == Motion::Resting) held.velocity = held.slip = {};
  path.state = HeldMotion(model, path).ballOf(held);
}

}  // namespace

std::uint32_t holderOf(const PathModel& model, Path path) {
  path.surface = kGround;
  const bool isOnGround = isHeldBy(model, path);
  path.surface = kWall;
  const bool isOnWall = isHeldBy(model, path);
  if (isOnGround == isOnWall) return kNoSurface;
  return isOnGround ? kGround : kWall;
}

void holdOn(const PathModel& model, Path& path) {
  const HeldMotion arriving(model, path);
  begin(motionOf(model, path, arriving), model, arriving.start(), path);
}

BallState heldStateAt(const PathModel& model, const Path& path, double t) {
  if (path.motion == Motion::Resting) return path.state;
  const HeldMotion motion(model, path);
  return motion.ballOf(heldAt(motion, path, t));
}

double endOfMotion(const PathModel& model, const Path& path, double until) {
  const HeldMotion motion(model, path);
  if (motion.isEndless()) return std::numeric_limits<double>::infinity();
  Held low = motion.start();
  double at = path.start;
  double atLow = motion.continuation(low, at);
  // A slip that begins has none at first.
  const double watched = atLow > 0 ? at : at + kBeginning * model.field->stretch;
  while (at < until) {
    const double most = motion.longestStep(low, at);
    const double next = until - at > most ? at + most : until;
    const Held high = motion.step(low, at, next - at);
    const double atHigh = motion.continuation(high, next);
    if (atHigh <= 0 && atLow > 0 && next > watched) {
      const auto f = [&](double t) { return motion.continuation(motion.step(low, at, t - at), t); };
      return zeroOf(f, at, atLow, next, atHigh);
    }
    low = high;
    at = next;
    atLow = atHigh;
  }
  return std::numeric_limits<double>::infinity();
}

Path pathAfter(const PathModel& model, const Path& path, double end) {
  Path next{stateAt(model, path, end), end, path.radius, Motion::Flying, path.surface};
  const HeldMotion motion(model, next);
  if (!(motion.loadOn(motion.start(), end).pressing > 0)) return next;
  // Where the grip has ended, rounding may say that it just suffices.
  if (hasLostGrip(model, path, end))
    begin(motionWithoutGrip(model, path, motion.loadOn(motion.start(), end)), model, motion.start(),
          next);
  else
    holdOn(model, next);
  return next;
}

}  // namespace wells
