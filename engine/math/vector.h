// Vec3 and the few products of it that the state depends on.
//
// Eigen supplies storage and the element-wise operators. Sums over components are written out here,
// because Eigen is free to reorder a reduction for the instruction set that it is compiled for, and
// the state must have the same bits on every processor.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace wells {

/// Three doubles. y is up; SI units unless said.
using Vec3 = Eigen::Vector3d;

/// a . b, summed as (x + y) + z.
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

inline double squaredLength(const Vec3& a) {
  return dot(a, a);
}

/// Euclidean length; sqrt is correctly rounded everywhere, unlike the rest of libm.
inline double length(const Vec3& a) {
  return std::sqrt(squaredLength(a));
}

inline bool isFinite(const Vec3& a) {
  return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z());
}

}  // namespace wells
