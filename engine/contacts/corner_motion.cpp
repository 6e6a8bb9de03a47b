#include "contacts/corner_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/held_motion.h"
#include "contacts/zero_of.h"

namespace wells {
namespace {

constexpr double kAcross = 1 / kInertiaFactor;                   // b' of friction across, 5/2
constexpr double kHolding = 1 / kSlipRatio;                      // on one contact that rolls, 2/7
constexpr double kHoldingBoth = 1 / (1 + kSlipRatio);            // on each of two, 2/9
constexpr double kSlipRatioOfOne = kSlipRatio - 1 / kSlipRatio;  // beside one that rolls, 45/14
constexpr double kFreeShare = 1 - kHolding;                      // of A_x, beside one that rolls
constexpr double kFiner = 1.0 / 16;  // than on one surface: a slip here may begin very slowly
constexpr double kStill = 1e-9;      // of the load: a rate that rounding may have made
constexpr int kMostHalvings = 60;    // of the search for a share

double signOf(double x) {
  return x < 0 ? -1 : 1;
}

Flat unit(Flat a) {
  return (1 / length(a)) * a;
}

/// The end that is nearer.
CornerMotion::End nearer(const CornerMotion::End& a, const CornerMotion::End& b) {
  return b.margin < a.margin ? b : a;
}

}  // namespace

CornerMotion::CornerMotion(const PathModel& model, const Path& path)
    : model_(model),
      path_(path),
      surface_(*model.arena, kWall, path.state.position, path.radius),
      drag_(dragRate(model.drag)) {
  const Frame frame = surface_.at({}).frame;
  const BallState& ball = path.state;
  start_.speed = dot(ball.velocity, frame.x);
  if (model.friction == 0) return;
  noise_ = slipNoise(ball, path.radius);
  if (!rollsOn(kWall)) start_.wallSlip = start_.speed - path.radius * dot(ball.spin, frame.y);
  if (!rollsOn(kGround))
    start_.groundSlip = start_.speed + path.radius * dot(ball.spin, frame.normal);
  if (path.rolling == kNoSurface) start_.across = path.radius * dot(ball.spin, frame.x);
  const Flat onWall{start_.wallSlip, start_.across};
  const Flat onGround{start_.groundSlip, start_.across};
  const Load load = loadOn(start_, path.start);
  // Beside one that rolls a contact can only slip along x.
  const auto alongWall = [&]() -> Flat { return {signOf(load.pull), 0}; };
  const bool beginsOnWall = length(onWall) <= noise_;
  const bool beginsOnGround = length(onGround) <= noise_;
  if (path.rolling == kNoSurface && beginsOnWall && beginsOnGround) {
    const CornerForces held = rollingForces(start_, load);
    Directions d{{0, -1}, {0, -1}};
    if (length(held.wallFriction) > 0) d.wall = unit(-1 * held.wallFriction);
    if (length(held.groundFriction) > 0) d.ground = unit(-1 * held.groundFriction);
    const double grows = turnToRates(start_, load, Small::OnBoth, d);
    beginsOnBoth_ = grows > -kStill * (std::abs(load.onWall) + std::abs(load.onGround));
    firstOnWall_ = d.wall;
    firstOnGround_ = d.ground;
    return;
  }
  if (!beginsOnWall)
    firstOnWall_ = unit(onWall);
  else
    firstOnWall_ = rollsOn(kGround) ? alongWall() : beginningOnWall(start_, load).direction;
  if (!beginsOnGround)
    firstOnGround_ = unit(onGround);
  else
    firstOnGround_ = rollsOn(kWall) ? alongWall() : beginningOnGround(start_, load).direction;
}

CornerMotion::Load CornerMotion::loadOn(const Cornered& now, double t) const {
  const Surface::Spot spot = surface_.at({now.place, 0});
  const Vec3 a = acceleration(*model_.field, spot.center, t);
  const double turning = surface_.curvature() * now.speed;
  return {dot(a, spot.frame.x) - drag_ * now.speed, turning * now.speed - dot(a, spot.frame.normal),
          -dot(a, spot.frame.y), turning};
}

/// The direction d in which a slip begins whose rate is P - M d, with M = m [[7/2, c], [0, 5/2]]:
/// that of its own rate, (M + lambda) d = P with lambda > 0 and |d| = 1. There is none where the
/// friction that holds the contact suffices, |d| <= 1 for lambda = 0.
CornerMotion::Beginning CornerMotion::beginningOf(Flat pull, double m, double c) {
  const auto at = [&](double lambda) -> Flat {
    const double y = pull.y / (kAcross * m + lambda);
    return {(pull.x - m * c * y) / (kSlipRatio * m + lambda), y};
  };
  if (!(length(pull) > 0)) return {};
  if (!(m > 0)) return {true, unit(pull)};
  const auto excess = [&](double lambda) { return length(at(lambda)) - 1; };
  const double atNone = excess(0);
  if (!(atNone > 0)) return {false, unit(at(0))};
  const double most = std::abs(pull.x) + std::abs(pull.y) + m * std::abs(c);
  return {true, unit(at(zeroOf(excess, 0, atNone, most, excess(most))))};
}

// Beside a ground on which the ball slides along x: N_w = W, N_g = Y + mu W d_y.
CornerMotion::Beginning CornerMotion::beginningOnWall(const Cornered& now, const Load& load) const {
  const double along = model_.friction * signOf(now.groundSlip);
  return beginningOf(
      {load.pull - along * load.onGround, load.turning * (now.groundSlip - now.speed)},
      model_.friction * std::max(0.0, load.onWall), along);
}

// Beside a wall on which the ball slides along x: N_g = Y, N_w = W - mu Y d_o.
CornerMotion::Beginning CornerMotion::beginningOnGround(const Cornered& now,
                                                        const Load& load) const {
  const double along = model_.friction * signOf(now.wallSlip);
  return beginningOf({load.pull - along * load.onWall, -load.turning * now.speed},
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
  constexpr double kNudge = 1e-7;
  constexpr double kTurned = 1e-12;
  constexpr double kMostTurn = 0.5;
  for (int i = 0; i < 40; ++i) {
    const Flat now0 = turning(d);
    const Flat byWall = (1 / kNudge) * (turning(turned(kNudge, 0)) - now0);
    const Flat byGround = (1 / kNudge) * (turning(turned(0, kNudge)) - now0);
    double onWall = 0;
    double onGround = 0;
    if (small == Small::OnBoth) {
      const double det = byWall.x * byGround.y - byWall.y * byGround.x;
      onWall = (byGround.x * now0.y - byGround.y * now0.x) / det;
      onGround = (byWall.y * now0.x - byWall.x * now0.y) / det;
    } else if (small == Small::OnWall) {
      onWall = -now0.x / byWall.x;
    } else {
      onGround = -now0.y / byGround.y;
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

CornerForces CornerMotion::rollingForces(const Cornered& now, const Load& load) const {
  const double whole = kInertiaFactor * load.turning * now.speed;
  const double along = -kHoldingBoth * load.pull;
  const double share = shareOfWall(load, whole);
  return {
      {along, share}, {along, whole - share}, load.onWall + whole - share, load.onGround - share};
}

// N_w = W - mu N_g e_o and N_g = Y + mu N_w d_y, d and e the directions of the slips.
CornerForces CornerMotion::slidingForces(const Load& load, const Directions& d) const {
  const double mu = model_.friction;
  const double both = 1 + mu * mu * std::max(0.0, d.ground.y * d.wall.y);
  const double wall = (load.onWall - mu * d.ground.y * load.onGround) / both;
  const double ground = (load.onGround + mu * d.wall.y * load.onWall) / both;
  return {-mu * std::max(0.0, wall) * d.wall, -mu * std::max(0.0, ground) * d.ground, wall, ground};
}

CornerForces CornerMotion::forcesOf(const Cornered& now, const Load& load) const {
  const double mu = model_.friction;
  CornerForces on{{}, {}, load.onWall, load.onGround};
  if (mu == 0) return on;
  if (path_.rolling == kCorner) {
    on = rollingForces(now, load);
  } else if (path_.rolling == kWall) {
    on.wallFriction.y = kInertiaFactor * load.turning * (now.speed - now.groundSlip);
    on.ground -= on.wallFriction.y;
    on.groundFriction.x = -mu * std::max(0.0, on.ground) * firstOnGround_.x;
    on.wallFriction.x = -kHolding * (load.pull + on.groundFriction.x);
  } else if (path_.rolling == kGround) {
    on.groundFriction.y = kInertiaFactor * load.turning * now.speed;
    on.wall += on.groundFriction.y;
    on.wallFriction.x = -mu * std::max(0.0, on.wall) * firstOnWall_.x;
    on.groundFriction.x = -kHolding * (load.pull + on.wallFriction.x);
  } else {
    on = slidingForces(load, directionsOf(now, load));
  }
  return on;
}

/// m/s^2, the wall's share of the `whole` by which friction turns the spin of a ball that rolls on
/// both: the one that leaves the contact with less grip to spare as much as can be. What the wall
/// can spare falls with its share; what the ground can spare rises, up to some share.
double CornerMotion::shareOfWall(const Load& load, double whole) const {
  const double mu = model_.friction;
  const double along = kHoldingBoth * load.pull;
  const auto wallLessGround = [&](double share) {
    return mu * (load.onWall + whole - share) - length(Flat{along, share}) -
           mu * (load.onGround - share) + length(Flat{along, whole - share});
  };
  // Further, the ground loses more by its load than it gains.
  double high = mu < 1 ? std::max(0.0, whole - mu * std::abs(along) / std::sqrt(1 - mu * mu)) : 0;
  double low = 0;
  if (!(wallLessGround(low) > 0)) return low;
  if (!(wallLessGround(high) < 0)) return high;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double middle = (low + high) / 2;
    (wallLessGround(middle) > 0 ? low : high) = middle;
  }
  return low;
}

CornerForces CornerMotion::forcesOn(const Cornered& now, double t) const {
  return forcesOf(now, loadOn(now, t));
}

Cornered CornerMotion::rateOf(const Cornered& now, double t) const {
  const Load load = loadOn(now, t);
  if (model_.friction == 0) return {now.speed, load.pull};
  if (path_.rolling == kCorner) return {now.speed, (1 - 2 * kHoldingBoth) * load.pull};
  return rateUnder(now, load, forcesOf(now, load));
}

Cornered CornerMotion::rateUnder(const Cornered& now, const Load& load,
                                 const CornerForces& on) const {
  const double f = on.wallFriction.x;
  const double g = on.groundFriction.x;
  Cornered rate{now.speed, load.pull + f + g};
  if (!rollsOn(kWall)) rate.wallSlip = load.pull + kSlipRatio * f + g;
  if (!rollsOn(kGround))
    rate.groundSlip = load.pull + f + kSlipRatio * g - load.turning * now.across;
  if (path_.rolling == kNoSurface)
    rate.across = kAcross * (on.wallFriction.y + on.groundFriction.y) +
                  load.turning * (now.groundSlip - now.speed);
  return rate;
}

Cornered CornerMotion::step(const Cornered& y, double t, double h) const {
  const Cornered a = rateOf(y, t);
  const Cornered b = rateOf(y + (h / 2) * a, t + h / 2);
  const Cornered c = rateOf(y + (h / 2) * b, t + h / 2);
  const Cornered d = rateOf(y + h * c, t + h);
  return y + (h / 6) * (a + 2 * (b + c) + d);
}

/// The longest step through a slip that turns: ever shorter while it ends; while it begins, which
/// is stiff, within what the method keeps stable.
double CornerMotion::stepFor(Flat slip, Flat rate, double pressing) const {
  const double whole = model_.field->stretch;
  const double size = length(slip);
  if (size <= noise_) return kBeginning * whole;
  const double friction = kSlipRatio * model_.friction * pressing;
  if (!(friction > 0)) return whole;
  const double least = kFiner * kShortestStep * whole;
  if (dot(rate, slip) < 0) return std::min(whole, std::max(least, kTurningShare * size / friction));
  return size <= smallSlip(pressing) ? whole : std::min(whole, std::max(least, size / friction));
}

double CornerMotion::longestStep(const Cornered& now, double t) const {
  double whole = model_.field->stretch;
  const double turning = surface_.curvature() * std::abs(now.speed);
  if (turning > 0) whole = std::min(whole, kLongestArc / turning);
  if (model_.friction == 0 || path_.rolling == kCorner) return whole;
  if (path_.rolling != kNoSurface) {
    const double slip = path_.rolling == kWall ? now.groundSlip : now.wallSlip;
    return std::abs(slip) > noise_ ? whole : kBeginning * whole;
  }
  const Cornered rate = rateOf(now, t);
  const CornerForces on = forcesOn(now, t);
  return std::min(
      {whole, stepFor({now.wallSlip, now.across}, {rate.wallSlip, rate.across}, on.wall),
       stepFor({now.groundSlip, now.across}, {rate.groundSlip, rate.across}, on.ground)});
}

CornerMotion::End CornerMotion::nextEnd(const Cornered& now, double t, NoSlip noSlip) const {
  const CornerForces on = forcesOn(now, t);
  const double mu = model_.friction;
  const End leaves = nearer({CornerEnd::LeavesGround, on.ground}, {CornerEnd::LeavesWall, on.wall});
  if (mu == 0) return leaves;
  const double wallGrip = mu * on.wall - length(on.wallFriction);
  const double groundGrip = mu * on.ground - length(on.groundFriction);
  if (path_.rolling == kCorner)
    return nearer(leaves, {CornerEnd::SlipsOnBoth, std::min(wallGrip, groundGrip)});
  // A slip that begins has none at first, and cannot end.
  const bool isEarly =
      noSlip == NoSlip::Begins && t < path_.start + kBeginning * model_.field->stretch;
  const auto slides = [&](CornerEnd end, Flat atStart, Flat slip, Flat first) -> End {
    const bool begins = isEarly && length(atStart) <= noise_;
    return {end, begins ? std::numeric_limits<double>::infinity() : dot(slip, first)};
  };
  const End onWall = rollsOn(kWall) ? End{CornerEnd::SlipsOnWall, wallGrip}
                                    : slides(CornerEnd::GripsWall, {start_.wallSlip, start_.across},
                                             {now.wallSlip, now.across}, firstOnWall_);
  const End onGround = rollsOn(kGround)
                           ? End{CornerEnd::SlipsOnGround, groundGrip}
                           : slides(CornerEnd::GripsGround, {start_.groundSlip, start_.across},
                                    {now.groundSlip, now.across}, firstOnGround_);
  return nearer(leaves, nearer(onWall, onGround));
}

bool CornerMotion::canBegin() const {
  if (model_.friction == 0) return true;
  const Load load = loadOn(start_, path_.start);
  const CornerForces on = forcesOf(start_, load);
  const double mu = model_.friction;
  const auto grips = [&](Flat friction, double pressing) {
    return length(friction) <= mu * pressing;
  };
  const auto slipsAlong = [&](double slip, double pressing) {
    return std::abs(slip) > noise_ ||
           kFreeShare * std::abs(load.pull) > kSlipRatioOfOne * mu * pressing;
  };
  if (path_.rolling == kCorner)
    return grips(on.wallFriction, on.wall) && grips(on.groundFriction, on.ground);
  if (path_.rolling == kWall)
    return grips(on.wallFriction, on.wall) && slipsAlong(start_.groundSlip, on.ground);
  if (path_.rolling == kGround)
    return grips(on.groundFriction, on.ground) && slipsAlong(start_.wallSlip, on.wall);
  return beginsOnBoth_ || std::abs(start_.across) > noise_ || std::abs(start_.wallSlip) > noise_ ||
         std::abs(start_.groundSlip) > noise_;
}

bool CornerMotion::beginsToTurn() const {
  return start_.speed == 0 && forcesOn(start_, path_.start).wall == 0 &&
         rateOf(start_, path_.start).speed != 0;
}

bool CornerMotion::isEndless() const {
  const Vec3& gravity = model_.field->gravity;
  const bool onlyPressed = model_.field->wells.empty() && gravity.x() == 0 && gravity.z() == 0;
  const bool keepsOn = model_.friction == 0 || (path_.rolling == kCorner && drag_ == 0);
  return onlyPressed && keepsOn && gravity.y() < 0 && start_.speed != 0;
}

BallState CornerMotion::ballOf(const Cornered& now) const {
  const Surface::Spot spot = surface_.at({now.place, 0});
  BallState ball{spot.center, now.speed * spot.frame.x, path_.state.spin};
  ball.position.y() = model_.arena->center.y() + path_.radius;
  if (model_.friction == 0) return ball;  // nothing turns it
  ball.spin =
      (1 / path_.radius) * (now.across * spot.frame.x + (now.speed - now.wallSlip) * spot.frame.y +
                            (now.groundSlip - now.speed) * spot.frame.normal);
  return ball;
}

}  // namespace wells
