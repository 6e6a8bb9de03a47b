// An independent path of one solid sphere that the ground y = 0 and the wall about the axis x = z =
// 0 hold at once, under gravity, drag and softened wells at rest: velocity and spin in the lab
// frame, the two contact forces from the six linear conditions that they must meet (no motion into
// or out of a surface, and for each either no slip or Coulomb's friction), in steps of textbook RK4
// so small that their error does not count. Uses nothing of engine/.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "support/body_step.h"
#include "support/event_driven.h"
#include "support/taylor_flight.h"

namespace wells::oracle {

enum class CornerFate { Held, LeftGround, LeftWall };

struct CorneredUntil {
  CornerFate fate = CornerFate::Held;
  Real time = 0;  // s, when it left, or all
};

class CornerBall {
 public:
  /// `drag` in 1/s.
  CornerBall(std::vector<SoftWell> wells, Real gravity, Real mu, Real drag = 0)
      : wells_(std::move(wells)), gravity_(gravity), mu_(mu), drag_(drag) {}

  /// Moves the ball, which touches both and moves along both, on by `duration` (s) or until one
  /// presses it no more.
  CorneredUntil move(Body& ball, Real duration) {
    sticks_ = chooseSticking(ball, {true, true});
    for (Real now = 0; now < duration;) {
      Real h = std::min(kStep, duration - now);
      if (mu_ > 0)
        for (const int c : {kGroundContact, kWallContact})
          if (!sticks_[c]) h = std::min(h, longest(ball, c));
      const Body next = step(ball, h);
      const Forces on = forces(next, sticks_);
      for (const int c : {kGroundContact, kWallContact})
        if (!(sticks_[0] && sticks_[1]) && pressing(next, on, c) <= 0) {
          now +=
              goTo(ball, h, [&](const Body& b) { return pressing(b, forces(b, sticks_), c) > 0; });
          return {c == kGroundContact ? CornerFate::LeftGround : CornerFate::LeftWall, now};
        }
      if (!grip(next, sticks_)) {
        now += goTo(ball, h, [&](const Body& b) { return grip(b, sticks_); });
        std::array<bool, 2> allowed = sticks_;
        if (allowed[0] && allowed[1]) {
          allowed = {false, true};
          if (!grip(ball, allowed) || !begins(ball, allowed, kGroundContact))
            allowed = {true, false};
          if (!grip(ball, allowed)) throw std::runtime_error("slips on both at once");
        } else {
          allowed = {false, false};
        }
        sticks_ = allowed;
        continue;
      }
      ball = next;
      now += h;
      if (mu_ > 0)
        for (const int c : {kGroundContact, kWallContact})
          if (!sticks_[c] && size(slip(ball, c)) < (sticks_[1 - c] ? 3 : 1) * kNoSlip) {
            std::array<bool, 2> more = sticks_;
            more[c] = true;
            if (grip(ball, more)) sticks_ = more;
          }
    }
    return {CornerFate::Held, duration};
  }

  /// On which the ball does not slip: ground, wall.
  std::array<bool, 2> sticks() const { return sticks_; }

 private:
  static constexpr int kGroundContact = 0, kWallContact = 1;
  static constexpr Real kStep = 5e-4L;     // s
  static constexpr Real kNoSlip = 1e-13L;  // m/s
  static constexpr Real kFollows =
      1e-6L;  // m/s, below which a slip that begins has its rate's direction

  /// Of ground and wall, per mass.
  using Forces = std::array<P, 2>;
  using Sticks = std::array<bool, 2>;

  using Rate = BodyRate;

  P field(const Body& b) const {
    P sum = P{0, -gravity_, 0} - drag_ * b.v;
    for (const SoftWell& well : wells_) {
      const P d = well.center - b.x;
      const Real q = inner(d, d) + well.softening * well.softening;
      sum = sum + well.strength / (q * std::sqrt(q)) * d;
    }
    return sum;
  }

  /// From the surface to the ball, and how it turns.
  static P normal(const Body& b, int c) {
    const Real rho = std::hypot(b.x.x, b.x.z);
    return c == kGroundContact ? P{0, 1, 0} : P{-b.x.x / rho, 0, -b.x.z / rho};
  }
  static P turning(const Body& b, int c) {
    const Real rho = std::hypot(b.x.x, b.x.z);
    return c == kGroundContact ? P{} : P{-b.v.x / rho, 0, -b.v.z / rho};
  }
  /// Two unit vectors across it.
  static std::array<P, 2> tangents(const Body& b, int c) {
    const P along = outer(P{0, 1, 0}, normal(b, kWallContact));
    return {along, outer(along, normal(b, c))};
  }
  static P slip(const Body& b, int c) { return b.v + outer(b.w, -b.r * normal(b, c)); }

  Rate rateUnder(const Body& b, const Forces& on) const {
    P torque;
    for (const int c : {kGroundContact, kWallContact})
      torque = torque + outer(-b.r * normal(b, c), on[c]);
    return {b.v, field(b) + on[0] + on[1], 2.5L / (b.r * b.r) * torque};
  }
  static P slipRate(const Body& b, const Rate& r, int c) {
    return r.v + outer(r.w, -b.r * normal(b, c)) + outer(b.w, -b.r * turning(b, c));
  }

  using Six = Eigen::Matrix<Real, 6, 1>;

  /// What must be zero.
  Six residual(const Body& b, const Sticks& sticks, const std::array<P, 2>& direction,
               const Forces& on) const {
    const Rate r = rateUnder(b, on);
    Six left;
    for (const int c : {kGroundContact, kWallContact}) {
      const P n = normal(b, c);
      left[3 * c] = inner(n, r.v) + inner(turning(b, c), b.v);
      for (int k = 0; k < 2; ++k) {
        const P t = tangents(b, c)[k];
        left[3 * c + 1 + k] =
            sticks[c] ? inner(t, slipRate(b, r, c))
                      : inner(t, on[c]) + mu_ * inner(n, on[c]) * inner(t, direction[c]);
      }
    }
    return left;
  }

  /// `share`: where both stick, with this friction up the wall.
  Forces solve(const Body& b, const Sticks& sticks, const std::array<P, 2>& direction,
               const Real* share = nullptr) const {
    const auto forcesOf = [](const Six& f) {
      return Forces{P{f[0], f[1], f[2]}, P{f[3], f[4], f[5]}};
    };
    Eigen::Matrix<Real, 7, 6> a = Eigen::Matrix<Real, 7, 6>::Zero();
    Eigen::Matrix<Real, 7, 1> right = Eigen::Matrix<Real, 7, 1>::Zero();
    const Six none = residual(b, sticks, direction, {});
    right.head<6>() = -none;
    for (int j = 0; j < 6; ++j)
      a.col(j).head<6>() = residual(b, sticks, direction, forcesOf(Six::Unit(j))) - none;
    if (share) a(6, 4) = 1, right[6] = *share;
    if (!sticks[0] || !sticks[1])
      return forcesOf(a.topRows<6>().fullPivLu().solve(right.head<6>()));
    return forcesOf(a.completeOrthogonalDecomposition().solve(right));
  }

  /// Directions of the slips; of one that begins, that of its rate: the fixed point of
  /// d ~ L d + u'(d), which L larger than what friction takes keeps stable.
  Forces forces(const Body& b, const Sticks& sticks) const {
    std::array<P, 2> direction;
    for (const int c : {kGroundContact, kWallContact}) {
      const Real speed = size(slip(b, c));
      if (speed > 0) direction[c] = 1 / speed * slip(b, c);
    }
    if (mu_ == 0) return solve(b, sticks, {});
    for (const int c : {kGroundContact, kWallContact})
      if (!sticks[c] && size(slip(b, c)) < kFollows && lacksGrip(b, sticks, c))
        direction[c] = beginning(b, sticks, direction, c);
    return solve(b, sticks, direction);
  }

  P beginning(const Body& b, const Sticks& sticks, std::array<P, 2> direction, int c) const {
    Sticks held = sticks;
    held[c] = true;
    const P n = normal(b, c);
    const bool onLine = sticks[1 - c];  // the spin across is held by the other
    const P line = tangents(b, c)[0];
    const auto across = [&](const P& a) {
      const P flat = onLine ? inner(a, line) * line : a - inner(a, n) * n;
      return 1 / size(flat) * flat;
    };
    direction[c] = across(-1 * solve(b, held, direction)[c]);
    for (int i = 0; i < 400; ++i) {
      const Forces on = solve(b, sticks, direction);
      const P rate = slipRate(b, rateUnder(b, on), c);
      const P next = across(3.5L * mu_ * inner(on[c], n) * direction[c] + rate);
      const Real change = size(next - direction[c]);
      direction[c] = next;
      if (change < 1e-17L) break;
    }
    return direction[c];
  }

  /// True where contact c could not be held if it did not slip.
  bool lacksGrip(const Body& b, const Sticks& sticks, int c) const {
    Sticks held = sticks;
    held[c] = true;
    return !grip(b, held);
  }

  bool begins(const Body& b, const Sticks& sticks, int c) const {
    const Forces on = forces(b, sticks);
    const P rate = slipRate(b, rateUnder(b, on), c);
    return inner(rate, on[c]) < 0;
  }

  static Real pressing(const Body& b, const Forces& on, int c) {
    return inner(on[c], normal(b, c));
  }

  Real spare(const Body& b, const Forces& on, int c) const {
    const P n = normal(b, c);
    return mu_ * inner(on[c], n) - size(on[c] - inner(on[c], n) * n);
  }

  /// Friction suffices where the ball sticks; where it does on both, by some share of what they
  /// must do together.
  bool grip(const Body& b, const Sticks& sticks) const {
    if (!sticks[0] && !sticks[1]) return true;
    if (!sticks[0] || !sticks[1]) {
      const int c = sticks[0] ? 0 : 1;
      std::array<P, 2> direction;
      const P u = slip(b, 1 - c);
      if (size(u) > 0) direction[1 - c] = 1 / size(u) * u;
      if (size(u) < kFollows && mu_ > 0 && lacksGripOnBoth(b))
        direction[1 - c] = beginning(b, sticks, direction, 1 - c);
      return spare(b, solve(b, sticks, direction), c) >= 0;
    }
    return !lacksGripOnBoth(b);
  }

  bool lacksGripOnBoth(const Body& b) const {
    const Real none = 0, one = 1;  // of the wall; between them the forces are linear
    const Forces zero = solve(b, {true, true}, {}, &none), unit = solve(b, {true, true}, {}, &one);
    const Real whole = -inner(zero[kGroundContact], normal(b, kWallContact));
    const auto least = [&](Real share) {
      const Forces on{zero[0] + share * (unit[0] - zero[0]), zero[1] + share * (unit[1] - zero[1])};
      return std::min(spare(b, on, 0), spare(b, on, 1));
    };
    Real low = 0, high = whole;  // of a concave function
    for (int i = 0; i < 120; ++i) {
      const Real a = low + (high - low) / 3, c = high - (high - low) / 3;
      (least(a) < least(c) ? low : high) = least(a) < least(c) ? a : c;
    }
    return least((low + high) / 2) < 0;
  }

  Sticks chooseSticking(const Body& b, Sticks allowed) const {
    for (const int c : {kGroundContact, kWallContact})
      allowed[c] = mu_ > 0 && allowed[c] && size(slip(b, c)) < kNoSlip;
    if (grip(b, allowed)) return allowed;
    if (allowed[0] && allowed[1]) {
      if (grip(b, {false, true})) return {false, true};
      if (grip(b, {true, false})) return {true, false};
    }
    return {false, false};
  }

  /// The longest step through a slip that may turn.
  Real longest(const Body& b, int c) const {
    const Forces on = forces(b, sticks_);
    Real speed = size(slip(b, c));
    if (inner(slip(b, c), slipRate(b, rateUnder(b, on), c)) > 0 || speed < kNoSlip)
      speed = std::max(speed, kFollows);
    return speed / (35 * mu_ * std::max<Real>(pressing(b, on, c), 1e-6L));
  }

  Rate rate(const Body& b) const { return rateUnder(b, forces(b, sticks_)); }

  Body step(const Body& b, Real h) const {
    return stepBody(b, h, [&](const Body& at) { return rate(at); });
  }

  template <class Lasts>
  Real goTo(Body& ball, Real h, Lasts lasts) const {
    return goToLast(ball, h, lasts, [&](const Body& b, Real s) { return step(b, s); });
  }

  std::vector<SoftWell> wells_;
  Real gravity_;
  Real mu_;
  Real drag_;
  Sticks sticks_{};
};

}  // namespace wells::oracle
