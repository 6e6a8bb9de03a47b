// A vector of long doubles, for oracles: 64 bits of mantissa, so that their rounding does not count
// beside that of doubles. Uses nothing of engine/.
#pragma once

#include <cmath>

namespace wells::oracle {

using Real = long double;

struct P {
  Real x = 0, y = 0, z = 0;
};

inline P operator+(const P& a, const P& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline P operator-(const P& a, const P& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline P operator*(Real s, const P& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Real inner(const P& a, const P& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline P outer(const P& a, const P& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real size(const P& a) {
  return std::sqrt(inner(a, a));
}

}  // namespace wells::oracle
