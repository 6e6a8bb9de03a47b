// An independent path of one solid sphere that the ground y = 0 holds, under gravity and softened
// wells at rest: velocity and spin by Newton and Euler, friction by Coulomb, in steps of textbook
// RK4 so small that their error does not count. Uses nothing of engine/.
#pragma once

#include <algorithm>
#include <vector>

#include "support/event_driven.h"
#include "support/taylor_flight.h"

namespace wells::oracle {

/// Left the ground, or still on it, at the end.
struct Grounded {
  bool lifted = false;
  Real time = 0;  // s, when it lifted, or all
};

class GroundedBall {
 public:
  GroundedBall(std::vector<SoftWell> wells, Real gravity, Real mu)
      : wells_(std::move(wells)), gravity_(gravity), mu_(mu) {}

  /// Moves the ball, which touches the ground with v.y = 0, on by `duration` (s) or until nothing
  /// presses it to the ground any more.
  Grounded move(Body& ball, Real duration) {
    rolls_ = size(slip(ball)) < kNoSlip && grips(ball);
    for (Real now = 0; now < duration;) {
      const P f = force(ball.x), u = slip(ball);
      Real h = std::min(kStep, duration - now);
      // The direction of a slip that begins or ends turns ever faster: steps are ever shorter.
      if (!rolls_ && mu_ > 0 && size(u) >= kNoSlip)
        h = std::min(h, (grows(f, u) ? std::max(size(u), kFollows) : size(u)) / (-35 * mu_ * f.y));
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

  static P slip(const Body& b) { return P{b.v.x, 0, b.v.z} + outer(b.w, {0, -b.r, 0}); }

  struct Rate {
    P x, v, w;
  };

  Rate rate(const Body& b) const {
    const P f = force(b.x);
    const P along{f.x, 0, f.z};
    P friction;  // per mass
    if (rolls_) {
      friction = -2.0L / 7 * along;
    } else if (mu_ > 0) {
      const P u = slip(b);
      const bool follows = size(u) < kNoSlip || (size(u) < kFollows && grows(f, u));
      const P direction = follows ? 1 / size(along) * along : 1 / size(u) * u;
      friction = mu_ * f.y * direction;  // f.y < 0
    }
    return {b.v, along + friction, 2.5L / (b.r * b.r) * outer({0, -b.r, 0}, friction)};
  }

  Body step(const Body& b, Real h) const {
    const auto moved = [&](const Rate& r, Real s) {
      Body next = b;
      next.x = b.x + s * r.x, next.v = b.v + s * r.v, next.w = b.w + s * r.w;
      return next;
    };
    const Rate k1 = rate(b), k2 = rate(moved(k1, h / 2)), k3 = rate(moved(k2, h / 2)),
               k4 = rate(moved(k3, h));
    const auto sum = [](const P& a, const P& c, const P& d, const P& e) {
      return 1 / 6.0L * (a + 2 * (c + d) + e);
    };
    return moved(
        {sum(k1.x, k2.x, k3.x, k4.x), sum(k1.v, k2.v, k3.v, k4.v), sum(k1.w, k2.w, k3.w, k4.w)}, h);
  }

  /// Force f per mass against friction, which takes 7/2 of its share from the slip u.
  bool grows(const P& f, const P& u) const { return inner(f, u) >= -3.5L * mu_ * f.y * size(u); }

  bool isPressed(const Body& b) const { return force(b.x).y < 0; }

  bool grips(const Body& b) const {
    const P f = force(b.x);
    return 2.0L / 7 * std::hypot(f.x, f.z) <= -mu_ * f.y;
  }

  /// Moves the ball to the last time within h at which `lasts`, and returns it.
  template <class Lasts>
  Real goTo(Body& ball, Real h, Lasts lasts) const {
    const Body start = ball;
    Real low = 0, high = h;
    for (int i = 0; i < 70; ++i) {
      const Real middle = (low + high) / 2;
      (lasts(step(start, middle)) ? low : high) = middle;
    }
    ball = step(start, low);
    return low;
  }

  std::vector<SoftWell> wells_;
  Real gravity_;
  Real mu_;
  bool rolls_ = false;
};

}  // namespace wells::oracle
