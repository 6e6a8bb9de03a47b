#include "contacts/corner.h"

#include <optional>

#include "contacts/corner_motion.h"
#include "contacts/held_motion.h"

namespace wells {
namespace {

// What the ends of slips give back to the other three, by the impulses that stop them.
constexpr double kOfOne = 1 / kSlipRatio;         // 2/7
constexpr double kOfBoth = 1 / (1 + kSlipRatio);  // 2/9

Cornered withoutSlip(Cornered now, std::uint32_t rolling) {
  if (rolling == kCorner)
    return {now.place, now.speed - kOfBoth * (now.wallSlip + now.groundSlip), 0, 0, 0};
  if (rolling == kWall)
    return {now.place, now.speed - kOfOne * now.wallSlip, 0, now.groundSlip - kOfOne * now.wallSlip,
            0};
  if (rolling == kGround)
    return {now.place, now.speed - kOfOne * now.groundSlip, now.wallSlip - kOfOne * now.groundSlip,
            0, 0};
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

/// Sets how the ball of `path` moves in the corner, and returns what holds it.
std::uint32_t chooseMotion(const PathModel& model, std::optional<CornerEnd> ended, Path& path) {
  path = slidingOnBoth(path);
  const Cornered now = CornerMotion(model, path).start();
  const double noise = slipNoise(path.state, path.radius);
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
    if (leavesWall) return leavesGround ? kNoSurface : kGround;
    if (leavesGround) return kWall;
    path.motion = rolling == kCorner ? Motion::Rolling : Motion::Sliding;
    const Cornered begun = withoutSlip(now, rolling);
    path.state = CornerMotion(model, path).ballOf(begun);
    return kCorner;
  }
  return kNoSurface;
}

}  // namespace

std::uint32_t holderInCorner(const PathModel& model, Path path) {
  return chooseMotion(model, {}, path);
}

void holdInCorner(const PathModel& model, Path& path) {
  chooseMotion(model, {}, path);
}

Path pathAfterCorner(const PathModel& model, const Path& path, double end) {
  Path next{stateAt(model, path, end), end, path.radius};
  Path ending = path;
  ending.state = next.state;
  ending.start = end;
  const CornerMotion motion(model, ending);
  CornerEnd ended = motion.nextEnd(motion.start(), end).what;
  if (ended == CornerEnd::LeavesWall || ended == CornerEnd::LeavesGround) {
    next.surface = ended == CornerEnd::LeavesWall ? kGround : kWall;
    return next;
  }
  Path chosen = next;
  const std::uint32_t holder = chooseMotion(model, ended, chosen);
  if (holder == kCorner) return chosen;
  next.surface = holder;
  return next;
}

}  // namespace wells
