// How a body moves whose rates are known: a step of the classical Runge-Kutta method, and the
// search for the time at which something ends.
#pragma once

#include "support/event_driven.h"

namespace wells::oracle {

struct BodyRate {
  P x, v, w;
};

/// rateOf(body) is its rate; h in s.
template <class RateOf>
Body stepBody(const Body& b, Real h, RateOf rateOf) {
  const auto moved = [&](const BodyRate& r, Real s) {
    Body next = b;
    next.x = b.x + s * r.x, next.v = b.v + s * r.v, next.w = b.w + s * r.w;
    return next;
  };
  const BodyRate k1 = rateOf(b), k2 = rateOf(moved(k1, h / 2)), k3 = rateOf(moved(k2, h / 2)),
                 k4 = rateOf(moved(k3, h));
  const auto sum = [](const P& a, const P& c, const P& d, const P& e) {
    return 1 / 6.0L * (a + 2 * (c + d) + e);
  };
  return moved(
      {sum(k1.x, k2.x, k3.x, k4.x), sum(k1.v, k2.v, k3.v, k4.v), sum(k1.w, k2.w, k3.w, k4.w)}, h);
}

/// Moves the ball by step(body, time) to the last time (s) within h at which lasts(body), and
/// returns it.
template <class Lasts, class Step>
Real goToLast(Body& ball, Real h, Lasts lasts, Step step) {
  const Body start = ball;
  Real low = 0, high = h;
  for (int i = 0; i < 70; ++i) {
    const Real middle = (low + high) / 2;
    (lasts(step(start, middle)) ? low : high) = middle;
  }
  ball = step(start, low);
  return low;
}

}  // namespace wells::oracle
