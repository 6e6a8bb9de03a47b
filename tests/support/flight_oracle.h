// An independent flight of one ball under gravity and softened wells at rest, for comparison with
// the engines: textbook RK4 in steps so small that its error does not count. Uses nothing of
// engine/.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace wells::oracle {

struct V {
  double x, y, z;
};

inline V operator+(const V& a, const V& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline V operator-(const V& a, const V& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V operator*(const V& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline double norm(const V& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

struct PointMass {
  V center;
  double strength;
  double softening;
};

struct Forces {
  double gravity = 9.81;  // m/s^2, downward
  std::vector<PointMass> wells;

  V acceleration(const V& x) const {
    V sum{0, -gravity, 0};
    for (const PointMass& well : wells) {
      const V d = well.center - x;
      const double s = std::hypot(norm(d), well.softening);
      sum = sum + d * (well.strength / (s * s * s));
    }
    return sum;
  }

  /// Bound on how fast the acceleration changes with place at x (1/s^2): 2 |S| / s^3 per well.
  double steepness(const V& x) const {
    double sum = 0;
    for (const PointMass& well : wells) {
      const double s = std::hypot(norm(well.center - x), well.softening);
      sum += 2 * std::abs(well.strength) / (s * s * s);
    }
    return sum;
  }
};

struct Ball {
  V x;
  V v;
};

inline Ball flyOneStep(const Forces& f, const Ball& b, double h) {
  const V a1 = f.acceleration(b.x);
  const V v2 = b.v + a1 * (h / 2);
  const V a2 = f.acceleration(b.x + b.v * (h / 2));
  const V v3 = b.v + a2 * (h / 2);
  const V a3 = f.acceleration(b.x + v2 * (h / 2));
  const V v4 = b.v + a3 * h;
  const V a4 = f.acceleration(b.x + v3 * h);
  return {b.x + (b.v + (v2 + v3) * 2 + v4) * (h / 6), b.v + (a1 + (a2 + a3) * 2 + a4) * (h / 6)};
}

inline Ball fly(const Forces& f, Ball b, double duration) {
  const int steps = std::max(1, static_cast<int>(std::ceil(duration * 4000)));
  for (int i = 0; i < steps; ++i) b = flyOneStep(f, b, duration / steps);
  return b;
}

}  // namespace wells::oracle
