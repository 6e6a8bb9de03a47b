#include "contacts/support.h"

#include <cmath>
#include <limits>

#include "contacts/corner.h"
#include "contacts/corner_motion.h"
#include "contacts/held_motion.h"
#include "contacts/motion_choice.h"
#include "contacts/zero_of.h"

namespace wells {
namespace {

/// True where the ball of a flying path touches the surface at path.start, and neither leaves nor
/// approaches it.
bool restsOn(const PathModel& model, const Path& path) {
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
  return withoutNoise(dot(ball.velocity, normal), noise * length(ball.velocity)) == 0;
}

/// At time t of a path that begins at `from`, on one surface (HeldMotion) or in the corner.
template <class HeldBall>
auto heldAt(const HeldBall& motion, double from, double t) {
  auto now = motion.start();
  double left = t - from;
  double at = from;
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
  return motion.isOverpowered(heldAt(motion, path.start, end), end);
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

template <class HeldBall>
double endAlong(const HeldBall& motion, const PathModel& model, double from, double until) {
  if (motion.isEndless()) return std::numeric_limits<double>::infinity();
  auto low = motion.start();
  double at = from;
  double atLow = motion.continuation(low, at);
  // A slip that begins has none at first.
  const double watched = atLow > 0 ? at : at + kBeginning * model.field->stretch;
  while (at < until) {
    const double most = motion.longestStep(low, at);
    const double next = until - at > most ? at + most : until;
    const auto high = motion.step(low, at, next - at);
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

}  // namespace

std::uint32_t holderOf(const PathModel& model, Path path) {
  path.surface = kGround;
  const bool isOnGround = restsOn(model, path);
  path.surface = kWall;
  const bool isOnWall = restsOn(model, path);
  if (!isOnGround && !isOnWall) return kNoSurface;
  path.surface = isOnGround ? kGround : kWall;
  const auto isPressed = [&] { return loadOn(model, path, path.start).pressing > 0; };
  if (isOnGround && isOnWall) {
    if (model.rollingResistance == 0) {
      path.surface = holderInCorner(model, path);
    } else {
      // Where both resist rolling, it is for the substeps.
      const bool onGround = isPressed();
      path.surface = kWall;
      if (onGround && isPressed()) return kNoSurface;
      if (onGround) path.surface = kGround;
    }
  }
  if (path.surface == kCorner || path.surface == kNoSurface) return path.surface;
  return isPressed() ? path.surface : kNoSurface;
}

void holdOn(const PathModel& model, Path& path) {
  if (path.surface == kCorner) return holdInCorner(model, path);
  const HeldMotion arriving(model, path);
  begin(motionOf(model, path, arriving), model, arriving.start(), path);
}

BallState heldStateAt(const PathModel& model, const Path& path, double t) {
  if (path.motion == Motion::Resting) return path.state;
  if (path.surface == kCorner) {
    const CornerMotion motion(model, path);
    return motion.ballOf(heldAt(motion, path.start, t));
  }
  const HeldMotion motion(model, path);
  return motion.ballOf(heldAt(motion, path.start, t));
}

double endOfMotion(const PathModel& model, const Path& path, double until) {
  return path.surface == kCorner ? endAlong(CornerMotion(model, path), model, path.start, until)
                                 : endAlong(HeldMotion(model, path), model, path.start, until);
}

Path pathAfter(const PathModel& model, const Path& path, double end) {
  Path next = path.surface == kCorner
                  ? pathAfterCorner(model, path, end)
                  : Path{stateAt(model, path, end), end, path.radius, Motion::Flying, path.surface};
  if (next.motion != Motion::Flying || next.surface == kNoSurface) return next;
  const HeldMotion motion(model, next);
  if (!(motion.loadOn(motion.start(), end).pressing > 0)) return next;
  // Where the grip has ended, rounding may say that it just suffices.
  if (path.surface != kCorner && hasLostGrip(model, path, end))
    begin(motionWithoutGrip(model, path, motion.loadOn(motion.start(), end)), model, motion.start(),
          next);
  else
    holdOn(model, next);
  return next;
}

}  // namespace wells
