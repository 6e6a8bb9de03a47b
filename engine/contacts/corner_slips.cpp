// Which way the slips of a ball in the corner point, as they begin and end, and how short the steps
// through them must be.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/corner_motion.h"
#include "contacts/held_motion.h"
#include "contacts/zero_of.h"

namespace wells {
namespace {

constexpr double kFiner = 1.0 / 16;  // than on one surface: a slip here may begin very slowly

// Of Newton's method, rad:
constexpr double kNudge = 1e-7;
constexpr double kTurned = 1e-12;  // is the same
constexpr double kMostTurn = 0.5;  // at once
constexpr int kMostTurns = 40;

/// The direction d in which a slip begins whose rate is P - M d, with M = m [[7/2, c], [0, 5/2]]:
/// that of its own rate, (M + lambda) d = P with lambda > 0 and |d| = 1. Where the friction -M d
/// suffices that holds the contact, |d| <= 1 for lambda = 0, the opposite of that.
Flat beginningOf(Flat pull, double m, double c) {
  const auto at = [&](double lambda) -> Flat {
    const double y = pull.y / (kSpinning * m + lambda);
    return {(pull.x - m * c * y) / (kSlipRatio * m + lambda), y};
  };
  if (!(length(pull) > 0)) return {};
  if (!(m > 0)) return unit(pull);
  const auto excess = [&](double lambda) { return length(at(lambda)) - 1; };
  const double atNone = excess(0);
  if (!(atNone > 0)) return unit(at(0));
  const double most = std::abs(pull.x) + std::abs(pull.y) + m * std::abs(c);
  return unit(at(zeroOf(excess, 0, atNone, most, excess(most))));
}

}  // namespace

// Beside a ground on which the ball slides along x: N_w = W, N_g = Y + mu W d_y.
Flat CornerMotion::beginningOnWall(const Load& load) const {
  const double along = std::copysign(model_.friction, start_.groundSlip);
  return beginningOf(
      {load.pull - along * load.onGround, load.turning * (start_.groundSlip - start_.speed)},
      model_.friction * std::max(0.0, load.onWall), along);
}

// Beside a wall on which the ball slides along x: N_g = Y, N_w = W - mu Y d_o.
Flat CornerMotion::beginningOnGround(const Load& load) const {
  const double along = std::copysign(model_.friction, start_.wallSlip);
  return beginningOf({load.pull - along * load.onWall, -load.turning * start_.speed},
                     model_.friction * std::max(0.0, load.onGround), -along);
}

/// m/s; a slip this small that begins has the direction of its rate.
double CornerMotion::smallSlip(double pressing) const {
  return kFiner * kFollowingShare * kSlipRatio * model_.friction * std::max(0.0, pressing) *
         model_.field->stretch;
}

/// Turns the directions of small slips to those of their rates, where they grow; by Newton's method
/// for the angles at which the rates don't turn them. Returns the rate (m/s^2) at which the slower
/// one grows, or -infinity where there are no such directions.
double CornerMotion::turnToRates(const Cornered& now, const Load& load, Small small,
                                 Directions& d) const {
  const double wall = small == Small::OnGround ? 0 : 1;
  const double ground = small == Small::OnWall ? 0 : 1;
  const auto rates = [&](const Directions& at) {
    return rateUnder(now, load, slidingForces(load, at));
  };
  const auto turned = [&](double onWall, double onGround) -> Directions {
    return {unit(d.wall + wall * onWall * Flat{-d.wall.y, d.wall.x}),
            unit(d.ground + ground * onGround * Flat{-d.ground.y, d.ground.x})};
  };
  const auto turning = [&](const Directions& at) -> Flat {  // x: on the wall, y: on the ground
    const Cornered r = rates(at);
    return {at.wall.x * r.across - at.wall.y * r.wallSlip,
            at.ground.x * r.across - at.ground.y * r.groundSlip};
  };
  for (int i = 0; i < kMostTurns; ++i) {
    const Flat turns = turning(d);
    const Flat byWall = (1 / kNudge) * (turning(turned(kNudge, 0)) - turns);
    const Flat byGround = (1 / kNudge) * (turning(turned(0, kNudge)) - turns);
    double onWall = 0;
    double onGround = 0;
    if (small == Small::OnBoth) {
      const double det = byWall.x * byGround.y - byWall.y * byGround.x;
      onWall = (byGround.x * turns.y - byGround.y * turns.x) / det;
      onGround = (byWall.y * turns.x - byWall.x * turns.y) / det;
    } else if (small == Small::OnWall) {
      onWall = -turns.x / byWall.x;
    } else {
      onGround = -turns.y / byGround.y;
    }
    const double most = std::max(std::abs(onWall), std::abs(onGround));
    if (!std::isfinite(most)) break;
    const double share = std::min(1.0, kMostTurn / most);
    d = most > 0 ? turned(share * onWall, share * onGround) : d;
    if (most > kTurned) continue;
    const Cornered r = rates(d);
    const double growsOnWall = d.wall.x * r.wallSlip + d.wall.y * r.across;
    const double growsOnGround = d.ground.x * r.groundSlip + d.ground.y * r.across;
    if (small == Small::OnBoth) return std::min(growsOnWall, growsOnGround);
    return small == Small::OnWall ? growsOnWall : growsOnGround;
  }
  return -std::numeric_limits<double>::infinity();
}

// What slips the other way than it began has begun to roll before, and only the search for that
// time asks.
CornerMotion::Directions CornerMotion::directionsOf(const Cornered& now, const Load& load) const {
  const Flat onWall{now.wallSlip, now.across};
  const Flat onGround{now.groundSlip, now.across};
  const Directions d{dot(onWall, firstOnWall_) <= noise_ ? firstOnWall_ : unit(onWall),
                     dot(onGround, firstOnGround_) <= noise_ ? firstOnGround_ : unit(onGround)};
  const bool smallOnWall = length(onWall) <= smallSlip(load.onWall);
  const bool smallOnGround = length(onGround) <= smallSlip(load.onGround);
  if (!smallOnWall && !smallOnGround) return d;
  const Small small = smallOnWall && smallOnGround ? Small::OnBoth
                      : smallOnWall                ? Small::OnWall
                                                   : Small::OnGround;
  Directions turned = d;
  if (!(turnToRates(now, load, small, turned) > 0)) return d;
  const bool keepsOn = dot(turned.wall, firstOnWall_) > 0 && dot(turned.ground, firstOnGround_) > 0;
  return keepsOn ? turned : d;
}

/// The longest step through a slip that turns: ever shorter while it ends; while it begins, which
/// is stiff, within what the method keeps stable.
double CornerMotion::stepFor(Flat slip, Flat rate, double pressing) const {
  const double whole = model_.field->stretch;
  const double size = length(slip);
  if (size <= noise_) return kBeginning * whole;
  const double friction = kSlipRatio * model_.friction * pressing;
  if (!(friction > 0)) return whole;
  const double least = kFiner * kShortestPart * whole;
  if (dot(rate, slip) < 0) return std::min(whole, std::max(least, kTurningShare * size / friction));
  return size <= smallSlip(pressing) ? whole : std::min(whole, std::max(least, size / friction));
}

}  // namespace wells
