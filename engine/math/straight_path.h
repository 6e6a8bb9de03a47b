// How near a straight path passes.
#pragma once

#include <algorithm>

#include "math/vector.h"

namespace wells {

/// m, from a point to the nearest place from `start` to `start` + `path` (m).
inline double distanceFromPath(const Vec3& point, const Vec3& start, const Vec3& path) {
  const double size = squaredLength(path);
  const double along = size > 0 ? std::clamp(dot(point - start, path) / size, 0.0, 1.0) : 0;
  return length(point - start - along * path);
}

}  // namespace wells
