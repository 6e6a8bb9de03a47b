// An independent flight of one ball under gravity and softened wells at rest, bouncing on the
// ground: power series of the solution in long double, and the impacts by bisection on the series.
// Uses nothing of engine/.
//
// With d = c - x, q = |d|^2 + softening^2 and w = q^(-3/2), x'' = S d w - g; the coefficients of w
// follow from those of q by q w' = -3/2 q' w:
//   k q_0 w_k = sum_{j<k} (-3/2 (k - j) - j) q_{k-j} w_j.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "support/long_vector.h"

namespace wells::oracle {

struct SoftWell {
  P center;
  Real strength;
  Real softening;
};

struct Flyer {
  P x;
  P v;
};

struct Bounces {
  std::vector<Real> times;  // s
};

class TaylorFlight {
 public:
  /// ground: height (m) of the centre at which it bounces with restitution e; none below -1e300.
  TaylorFlight(std::vector<SoftWell> wells, Real gravity, Real ground = -1e301L, Real e = 1)
      : wells_(std::move(wells)), gravity_(gravity), ground_(ground), e_(e) {}

  /// Moves `ball` on by `duration` (s).
  Bounces fly(Flyer& ball, Real duration) {
    Bounces bounces;
    for (Real now = 0; now < duration;) {
      expand(ball);
      Real s = std::min(safeStep(), duration - now);
      const bool bounced = findGround(s);
      ball = {{at(0, s), at(1, s), at(2, s)}, {rate(0, s), rate(1, s), rate(2, s)}};
      now += s;
      if (!bounced) continue;
      ball.x.y = ground_;
      ball.v.y *= -e_;
      bounces.times.push_back(now);
    }
    return bounces;
  }

 private:
  static constexpr int kOrder = 30;
  using Series = std::array<Real, kOrder + 1>;

  static Real product(const Series& a, const Series& b, int n) {
    Real sum = 0;
    for (int k = 0; k <= n; ++k) sum += a[k] * b[n - k];
    return sum;
  }

  void expand(const Flyer& ball) {
    const Real start[3] = {ball.x.x, ball.x.y, ball.x.z};
    const Real speed[3] = {ball.v.x, ball.v.y, ball.v.z};
    for (int i = 0; i < 3; ++i) x_[i][0] = start[i], x_[i][1] = speed[i];
    std::vector<std::array<Series, 5>> all(wells_.size());  // d (3), q, w
    for (int n = 0; n + 2 <= kOrder; ++n) {
      Real a[3] = {0, n == 0 ? -gravity_ : 0, 0};
      for (std::size_t k = 0; k < wells_.size(); ++k) {
        auto& [dx, dy, dz, q, w] = all[k];
        const P& c = wells_[k].center;
        dx[n] = (n == 0 ? c.x : 0) - x_[0][n];
        dy[n] = (n == 0 ? c.y : 0) - x_[1][n];
        dz[n] = (n == 0 ? c.z : 0) - x_[2][n];
        q[n] = product(dx, dx, n) + product(dy, dy, n) + product(dz, dz, n);
        if (n == 0) {
          q[0] += wells_[k].softening * wells_[k].softening;
          w[0] = 1 / (q[0] * std::sqrt(q[0]));
        } else {
          Real sum = 0;
          for (int j = 0; j < n; ++j) sum += (-1.5L * (n - j) - j) * q[n - j] * w[j];
          w[n] = sum / (n * q[0]);
        }
        a[0] += wells_[k].strength * product(dx, w, n);
        a[1] += wells_[k].strength * product(dy, w, n);
        a[2] += wells_[k].strength * product(dz, w, n);
      }
      for (int i = 0; i < 3; ++i) x_[i][n + 2] = a[i] / ((n + 1) * (n + 2));
    }
  }

  /// The last terms of the series stay below 1e-22 m.
  Real safeStep() const {
    Real step = 0.25;
    for (int n = kOrder - 2; n <= kOrder; ++n)
      for (const Series& x : x_)
        if (x[n] != 0) step = std::min(step, std::pow(1e-22L / std::abs(x[n]), Real(1) / n));
    return step;
  }

  Real at(int i, Real s) const {
    Real sum = 0;
    for (int n = kOrder; n >= 0; --n) sum = sum * s + x_[i][n];
    return sum;
  }

  Real rate(int i, Real s) const {
    Real sum = 0;
    for (int n = kOrder; n >= 1; --n) sum = sum * s + n * x_[i][n];
    return sum;
  }

  /// True, and s is shortened to it, when the ball meets the ground before s.
  bool findGround(Real& s) const {
    constexpr int kPieces = 16;
    for (int k = 1; k <= kPieces; ++k) {
      Real open = s * (k - 1) / kPieces, closed = s * k / kPieces;
      if (at(1, closed) >= ground_) continue;
      for (int i = 0; i < 80; ++i) {
        const Real middle = (open + closed) / 2;
        (at(1, middle) < ground_ ? closed : open) = middle;
      }
      s = open;
      return true;
    }
    return false;
  }

  std::vector<SoftWell> wells_;
  Real gravity_;
  Real ground_;
  Real e_;
  std::array<Series, 3> x_{};
};

}  // namespace wells::oracle
