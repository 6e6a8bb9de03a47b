// The contact list of the custom integrator: all contacts of a step, found first, resolved together
// afterwards.
//
// It keeps the report's conventions, not the house's: the normal points from the second ball to the
// first, and overlap is a positive penetration.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "math/vector.h"

namespace wells {

/// Stands for the second ball where a ball touches the ground or the wall.
inline constexpr std::uint32_t kNoBall = std::numeric_limits<std::uint32_t>::max();

struct ManifoldContact {
  std::uint32_t first = 0;
  std::uint32_t second = kNoBall;
  Vec3 normal = Vec3::Zero();  // unit, from the second (or ground, or wall) to the first
  double penetration = 0;      // m, as the report computes it; may be negative at the wall

  friend bool operator==(const ManifoldContact&, const ManifoldContact&) = default;
};

/// In this order: ground by id, wall by id, ordered pairs (i, j) by i, then j.
using Manifold = std::vector<ManifoldContact>;

}  // namespace wells
