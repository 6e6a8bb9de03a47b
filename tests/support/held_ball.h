// An independent path of one solid sphere that the ground y = 0, or the wall about the axis x = z =
// 0, holds, under gravity and softened wells at rest: velocity and spin by Newton and Euler in the
// lab frame, friction by Coulomb, rolling resistance as a torque of its lever arm times the normal
// force, in steps of textbook RK4 so small that their error does not count. Uses nothing of
// engine/.
#pragma once

#include <algorithm>
#include <vector>

#include "support/body_step.h"
#include "support/event_driven.h"
#include "support/taylor_flight.h"

namespace wells::oracle {

/// Left the surface, or still on it, at the end.
struct HeldUntil {
  bool lifted = false;
  Real time = 0;  // s, when it lifted, or all
};

enum class Support { Ground, Wall };

class HeldBall {
 public:
  HeldBall(Support support, std::vector<SoftWell> wells, Real gravity, Real mu, Real arm = 0)
      : support_(support), wells_(std::move(wells)), gravity_(gravity), mu_(mu), arm_(arm) {}

  /// Moves the ball, which touches its support and moves along it, on by `duration` (s) or until
  /// nothing presses it any more.
  HeldUntil move(Body& ball, Real duration) {
    rolls_ = size(slip(ball)) < kNoSlip && grips(ball);
    for (Real now = 0; now < duration;) {
      if (arm_ > 0 && rests(ball)) {
        ball.v = {};
        return {false, duration};
      }
      const P f = slipForce(ball) + resisted(ball), u = slip(ball);
      Real h = std::min(kStep, duration - now);
      // The direction of a slip that begins or ends turns ever faster: steps are ever shorter.
      if (!rolls_ && mu_ > 0 && size(u) >= kNoSlip)
        h = std::min(h, (grows(ball, f) ? std::max(size(u), kFollows) : size(u)) /
                            (35 * mu_ * pressing(ball)));
      const Real c = size(lag(ball)), braking = 2.5L * arm_ / ball.r * pressing(ball);
      if (braking > 0 && c >= kNoSlip)
        h = std::min(
            h, (size(tangent(force(ball.x), normal(ball.x))) > braking / 2.5L ? std::max(c, kTurns)
                                                                              : c) /
                   (10 * braking));
      const Body next = step(ball, h);
      if (!isPressed(next)) {
        now += goTo(ball, h, [&](const Body& b) { return isPressed(b); });
        return {true, now};
      }
      if (rolls_ && !grips(next)) {
        now += goTo(ball, h, [&](const Body& b) { return grips(b); });
        rolls_ = false;
        continue;
      }
      ball = next;
      now += h;
      if (!rolls_ && mu_ > 0 && size(slip(ball)) < kNoSlip && grips(ball)) rolls_ = true;
    }
    return {false, duration};
  }

 private:
  static constexpr Real kStep = 2e-4L;     // s
  static constexpr Real kNoSlip = 1e-13L;  // m/s
  static constexpr Real kFollows = 1e-6L;  // m/s, below which a slip that begins follows the pull
  static constexpr Real kTurns = 1e-9L;    // m/s, the same of a turning

  /// Per mass.
  P force(const P& x) const {
    P sum{0, -gravity_, 0};
    for (const SoftWell& well : wells_) {
      const P d = well.center - x;
      const Real q = inner(d, d) + well.softening * well.softening;
      sum = sum + well.strength / (q * std::sqrt(q)) * d;
    }
    return sum;
  }

  /// From the support to the ball.
  P normal(const P& x) const {
    if (support_ == Support::Ground) return {0, 1, 0};
    const Real rho = std::hypot(x.x, x.z);
    return {-x.x / rho, 0, -x.z / rho};
  }

  static P tangent(const P& a, const P& n) { return a - inner(a, n) * n; }

  P slip(const Body& b) const {
    const P n = normal(b.x);
    return tangent(b.v + outer(b.w, -b.r * n), n);
  }

  /// N = v_phi^2 / rho - f . n, per mass.
  Real pressing(const Body& b) const {
    const P n = normal(b.x);
    const Real pressed = -inner(force(b.x), n);
    if (support_ == Support::Ground) return pressed;
    const P along = tangent({b.v.x, 0, b.v.z}, n);
    return pressed + inner(along, along) / std::hypot(b.x.x, b.x.z);
  }

  /// What the slip u = v - r w x n gains per second without friction: the force along the surface
  /// less r w x n', for the normal turns with the ball.
  P slipForce(const Body& b) const {
    const P n = normal(b.x);
    const P along = tangent(force(b.x), n);
    if (support_ == Support::Ground) return along;
    const P turning = -1 / std::hypot(b.x.x, b.x.z) * tangent({b.v.x, 0, b.v.z}, n);
    return along - tangent(b.r * outer(b.w, turning), n);
  }

  /// r w x n, how fast the centre would move if the ball rolled.
  P lag(const Body& b) const { return b.r * outer(b.w, normal(b.x)); }

  /// On the ground alone: where friction cannot turn it against the resistance.
  bool isLocked(const Body& b) const {
    return !rolls_ && arm_ >= mu_ * b.r && size(lag(b)) < kNoSlip;
  }

  /// 5/2 b/r N to the lag, by which rolling resistance adds to the slip.
  P resisted(const Body& b) const {
    if (arm_ == 0) return {};
    const P c = lag(b), n = normal(b.x), f = tangent(force(b.x), n);
    const Real most = 2.5L * arm_ / b.r * pressing(b);
    const bool follows = size(c) < kNoSlip || (size(c) < kTurns && size(f) > most / 2.5L);
    const P ahead = !follows ? c : rolls_ ? f : slip(b);
    return size(ahead) > 0 ? most / size(ahead) * ahead : P{};
  }

  bool rests(const Body& b) const {
    const P f = tangent(force(b.x), normal(b.x));
    return size(lag(b)) < kNoSlip && size(slip(b)) < kNoSlip &&
           size(f) <= std::min(mu_, arm_ / b.r) * pressing(b);
  }

  using Rate = BodyRate;

  Rate rate(const Body& b) const {
    const P n = normal(b.x), braking = resisted(b), pull = slipForce(b) + braking;
    P friction;  // per mass
    if (rolls_) {
      friction = -2.0L / 7 * pull;
    } else if (mu_ > 0) {
      const P u = slip(b);
      const bool follows = size(u) < kNoSlip || (size(u) < kFollows && grows(b, pull));
      const P direction = follows ? 1 / size(pull) * pull : 1 / size(u) * u;
      friction = -mu_ * pressing(b) * direction;
    }
    const P turned = 2.5L / (b.r * b.r) * outer(-b.r * n, friction) - 1 / b.r * outer(n, braking);
    return {b.v, force(b.x) + pressing(b) * n + friction, isLocked(b) ? P{} : turned};
  }

  Body step(const Body& b, Real h) const {
    return stepBody(b, h, [&](const Body& at) { return rate(at); });
  }

  /// The force f per mass against friction, which takes 7/2 of its share from a slip.
  bool grows(const Body& b, const P& f) const { return size(f) >= 3.5L * mu_ * pressing(b); }

  bool isPressed(const Body& b) const { return pressing(b) > 0; }

  bool grips(const Body& b) const {
    return 2.0L / 7 * size(slipForce(b) + resisted(b)) <= mu_ * pressing(b);
  }

  template <class Lasts>
  Real goTo(Body& ball, Real h, Lasts lasts) const {
    return goToLast(ball, h, lasts, [&](const Body& b, Real s) { return step(b, s); });
  }

  Support support_;
  std::vector<SoftWell> wells_;
  Real gravity_;
  Real mu_;
  Real arm_;  // m, of rolling resistance
  bool rolls_ = false;
};

}  // namespace wells::oracle
