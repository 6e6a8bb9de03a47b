#include "contacts/corner.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contacts/corner_motion.h"
#include "contacts/held_motion.h"

namespace wells {
namespace {

constexpr double kHiddenHop = 1e-13;   // of the size of the coordinates
constexpr double kEndingSlip = 1e-10;  // of the same, for about the way that it goes on

/// The impulses that stop the slips give the other three what such friction would.
Cornered withoutSlip(Cornered now, std::uint32_t rolling) {
  if (rolling == kCorner)
    return {now.place, now.speed - kHoldingBoth * (now.wallSlip + now.groundSlip), 0, 0, 0};
  if (rolling == kWall)
    return {now.place, now.speed - kHolding * now.wallSlip, 0,
            now.groundSlip - kHolding * now.wallSlip, 0};
  if (rolling == kGround)
    return {now.place, now.speed - kHolding * now.groundSlip,
            now.wallSlip - kHolding * now.groundSlip, 0, 0};
  return now;
}

Path slidingOnBoth(Path path) {
  path.motion = Motion::Sliding;
  path.surface = kCorner;
  path.rolling = kNoSurface;
  return path;
}

/// Rounding may say that a grip that has ended just suffices.
bool isOver(std::uint32_t rolling, std::optional<CornerEnd> ended) {
  const bool onWall = rolling == kWall || rolling == kCorner;
  const bool onGround = rolling == kGround || rolling == kCorner;
  return (ended == CornerEnd::SlipsOnWall && onWall) ||
         (ended == CornerEnd::SlipsOnGround && onGround) ||
         (ended == CornerEnd::SlipsOnBoth && rolling == kCorner);
}

/// Sets how the ball of `path` moves in the corner, and returns what holds it: where that is not
/// the corner, only the state counts. A slip up to `noise` (m/s) is none.
std::uint32_t chooseMotion(const PathModel& model, double noise, std::optional<CornerEnd> ended,
                           Path& path) {
  path = slidingOnBoth(path);
  const Cornered now = CornerMotion(model, path).start();
  const bool mayRoll = model.friction > 0;
  const bool mayRollOnWall = mayRoll && length(Flat{now.wallSlip, now.across}) <= noise;
  const bool mayRollOnGround = mayRoll && length(Flat{now.groundSlip, now.across}) <= noise;
  for (const std::uint32_t rolling : {kCorner, kWall, kGround, kNoSurface}) {
    if ((rolling == kWall || rolling == kCorner) && !mayRollOnWall) continue;
    if ((rolling == kGround || rolling == kCorner) && !mayRollOnGround) continue;
    path.rolling = rolling;
    const CornerMotion motion(model, path);
    const CornerForces on = motion.forcesOn(motion.start(), path.start);
    // Rolling on both, neither can be pressed more than if the other bore its whole share.
    const double share = rolling == kCorner ? on.wallFriction.y : 0;
    const bool leavesWall = on.wall + share <= 0 && !motion.beginsToTurn();
    const bool leavesGround = on.ground + share <= 0;
    const bool mayBegin = motion.canBegin() && !isOver(rolling, ended);
    if (!mayBegin && !(rolling == kCorner && (leavesWall || leavesGround))) continue;
    path.motion = rolling == kCorner ? Motion::Rolling : Motion::Sliding;
    path.state = CornerMotion(model, path).ballOf(withoutSlip(now, rolling));
    if (leavesWall) return leavesGround ? kNoSurface : kGround;
    if (leavesGround) return kWall;
    return kCorner;
  }
  return kNoSurface;
}

/// Friction may take the ball from one surface just before its slip on the other ends, and then the
/// ball is pressed back. Taking b from the slip, it gives the ball 2/5 b. Where rounding hides that
/// hop, the slip ends at once and the ball stays: true, with the path that follows.
bool staysInCorner(const PathModel& model, const CornerMotion& ending, CornerEnd from, Path& path) {
  const bool fromWall = from == CornerEnd::LeavesWall;
  const Cornered& now = ending.start();
  const CornerForces on = ending.forcesOn(now, path.start);
  const double slip = length(Flat{fromWall ? now.groundSlip : now.wallSlip, now.across});
  const double friction = model.friction * (fromWall ? on.ground : on.wall);
  const double size = length(model.arena->center) + model.arena->radius;
  if (!(friction > 0 && slip * slip <= kEndingSlip * size * friction)) return false;
  Path staying = path;
  if (chooseMotion(model, slip, std::nullopt, staying) != kCorner) return false;
  const CornerMotion motion(model, staying);
  const CornerForces then = motion.forcesOn(motion.start(), path.start);
  const double rising = kInertiaFactor * now.across;
  if (rising * rising > 2 * (fromWall ? then.wall : then.ground) * kHiddenHop * size) return false;
  path = staying;
  return true;
}

}  // namespace

std::uint32_t holderInCorner(const PathModel& model, Path path) {
  return chooseMotion(model, slipNoise(path.state, path.radius), {}, path);
}

void holdInCorner(const PathModel& model, Path& path) {
  chooseMotion(model, slipNoise(path.state, path.radius), {}, path);
}

Path pathAfterCorner(const PathModel& model, const Path& path, double end) {
  Path next{stateAt(model, path, end), end, path.radius};
  Path ending = path;
  ending.state = next.state;
  ending.start = end;
  const CornerMotion motion(model, ending);
  const CornerEnd ended = motion.nextEnd(motion.start(), end, CornerMotion::NoSlip::HasEnded).what;
  if (ended == CornerEnd::LeavesWall || ended == CornerEnd::LeavesGround) {
    if (!staysInCorner(model, motion, ended, next))
      next.surface = ended == CornerEnd::LeavesWall ? kGround : kWall;
    return next;
  }
  Path staying = next;
  // Where a slip has taken all motion with it, rounding is that of what there was before.
  const double noise =
      std::max(slipNoise(path.state, path.radius), slipNoise(next.state, next.radius));
  next.surface = chooseMotion(model, noise, ended, staying);
  next.state = staying.state;
  return next.surface == kCorner ? staying : next;
}

}  // namespace wells
