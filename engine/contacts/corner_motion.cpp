#include "contacts/corner_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/held_motion.h"

namespace wells {
namespace {

constexpr double kSlipRatioOfOne = kSlipRatio - 1 / kSlipRatio;  // beside one that rolls, 45/14
constexpr double kFreeShare = 1 - kHolding;                      // of A_x, beside one that rolls
constexpr double kStill = 1e-9;    // of the load: a rate that rounding may have made
constexpr int kMostHalvings = 60;  // of the search for a share

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
  const auto alongWall = [&]() -> Flat { return {std::copysign(1.0, load.pull), 0}; };
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
    firstOnWall_ = rollsOn(kGround) ? alongWall() : beginningOnWall(load);
  if (!beginsOnGround)
    firstOnGround_ = unit(onGround);
  else
    firstOnGround_ = rollsOn(kWall) ? alongWall() : beginningOnGround(load);
}

CornerMotion::Load CornerMotion::loadOn(const Cornered& now, double t) const {
  const Surface::Spot spot = surface_.at({now.place, 0});
  const Vec3 a = acceleration(*model_.field, spot.center, t);
  const double turning = surface_.curvature() * now.speed;
  return {dot(a, spot.frame.x) - drag_ * now.speed, turning * now.speed - dot(a, spot.frame.normal),
          -dot(a, spot.frame.y), turning};
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
    rate.across = kSpinning * (on.wallFriction.y + on.groundFriction.y) +
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
