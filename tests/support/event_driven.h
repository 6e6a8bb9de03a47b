// An independent event-driven reference: solid spheres in uniform gravity, the ground y = 0, the
// wall about the y axis, restitution and Coulomb friction with spin. Brute force: before each
// impact the quadratic of every pair is solved anew. One impact at a time: not for impacts of one
// instant that share a ball, nor for contacts that last. Uses nothing of engine/.
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/long_vector.h"

namespace wells::oracle {

struct Body {
  P x;           // m, centre
  P v;           // m/s
  P w;           // rad/s
  Real r = 0.5;  // m
  Real m = 1;    // kg
};

struct Rules {
  Real gravity = 0;  // m/s^2, downward
  Real e = 1;
  Real mu = 0;
  Real wall = 40;  // m
};

struct Hits {
  std::int64_t count = 0;
  Real last = 0;  // s
};

namespace detail {

constexpr Real kNever = std::numeric_limits<Real>::infinity();

/// |d + u s| = sum for the first s >= 0 at which it decreases: a s^2 + 2 b s + c = 0.
inline Real timeToBall(const Body& p, const Body& q) {
  const P d = q.x - p.x, u = q.v - p.v;
  const Real a = inner(u, u), b = inner(d, u), c = inner(d, d) - (p.r + q.r) * (p.r + q.r);
  if (b >= 0 || b * b - a * c < 0) return kNever;
  return std::max<Real>(0, c / (-b + std::sqrt(b * b - a * c)));
}

inline Real timeToGround(const Body& p, Real g) {
  const Real gap = p.x.y - p.r;
  if (g == 0) return p.v.y < 0 ? std::max<Real>(0, gap / -p.v.y) : kNever;
  const Real root = std::sqrt(std::max<Real>(0, p.v.y * p.v.y + 2 * g * gap));
  return std::max<Real>(0, (p.v.y + root) / g);
}

inline Real timeToWall(const Body& p, Real wall) {
  const Real reach = wall - p.r;
  const Real a = p.v.x * p.v.x + p.v.z * p.v.z, b = p.x.x * p.v.x + p.x.z * p.v.z;
  const Real c = reach * reach - p.x.x * p.x.x - p.x.z * p.x.z;
  if (a == 0) return kNever;
  const Real root = std::sqrt(std::max<Real>(0, b * b + a * c));
  return std::max<Real>(0, b > 0 ? c / (b + root) : (root - b) / a);
}

/// n: unit, from p to q, or to the arena where q is null.
inline void hit(const Rules& rules, const P& n, Body& p, Body* q) {
  const Real inverse = 1 / p.m + (q ? 1 / q->m : 0);
  P u = p.v + outer(p.w, p.r * n);  // of p's surface against q's
  if (q) u = u - q->v - outer(q->w, -q->r * n);
  const Real closing = inner(u, n);
  const P slip = u - closing * n;
  const Real pressed = (1 + rules.e) * closing / inverse;
  // A solid sphere's surface gives way 5/2 times as much by turning as by moving.
  const Real sticking = 1 / (inverse * (1 + Real(5) / 2));
  const Real sliding = size(slip) > 0 ? rules.mu * pressed / size(slip) : 0;
  const P onP = -pressed * n - std::min(sticking, sliding) * slip;
  const auto give = [](Body& b, const P& arm, const P& impulse) {
    b.v = b.v + 1 / b.m * impulse;
    b.w = b.w + 1 / (Real(2) / 5 * b.m * b.r * b.r) * outer(arm, impulse);
  };
  give(p, p.r * n, onP);
  if (q) give(*q, -q->r * n, -1 * onP);
}

}  // namespace detail

/// Moves `bodies` on by `duration` (s). Throws after `mostHits`.
inline Hits fly(const Rules& rules, std::vector<Body>& bodies, Real duration,
                std::int64_t mostHits = 1'000'000) {
  using namespace detail;
  constexpr std::size_t kGround = std::size_t(-1), kWall = std::size_t(-2);
  Hits hits;
  for (Real now = 0;;) {
    Real first = kNever;
    std::size_t a = 0, b = 0;
    const auto consider = [&](Real time, std::size_t i, std::size_t j) {
      if (time < first) first = time, a = i, b = j;
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      consider(timeToGround(bodies[i], rules.gravity), i, kGround);
      consider(timeToWall(bodies[i], rules.wall), i, kWall);
      for (std::size_t j = i + 1; j < bodies.size(); ++j)
        consider(timeToBall(bodies[i], bodies[j]), i, j);
    }
    const bool ends = now + first >= duration;
    const Real s = ends ? duration - now : first;
    for (Body& body : bodies) {
      body.x = body.x + s * body.v - P{0, rules.gravity * s * s / 2, 0};
      body.v.y -= rules.gravity * s;
    }
    now += s;
    if (ends) return hits;
    if (++hits.count > mostHits) throw std::runtime_error("the impacts do not end");
    hits.last = now;
    Body& p = bodies[a];
    if (b == kGround) {
      hit(rules, {0, -1, 0}, p, nullptr);
    } else if (b == kWall) {
      const Real rho = std::hypot(p.x.x, p.x.z);
      hit(rules, {p.x.x / rho, 0, p.x.z / rho}, p, nullptr);
    } else {
      const P d = bodies[b].x - p.x;
      hit(rules, 1 / size(d) * d, p, &bodies[b]);
    }
  }
}

}  // namespace wells::oracle
