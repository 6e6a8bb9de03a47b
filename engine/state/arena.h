// Where the balls live: a ground plane and, standing on it, a circular wall without top.
#pragma once

#include <cstdint>

#include "math/vector.h"

namespace wells {

/// The ground is the plane y = center.y, normal up. The wall is the inside of the cylinder of the
/// given radius about the vertical through the centre. Both are exact: no polygons.
struct Arena {
  Vec3 center = Vec3::Zero();  // m
  double radius = 40;          // m, > the radius of every ball
};

// What stands for a piece of the arena where the partner of a ball may be another ball's number.
inline constexpr std::uint32_t kGround = 0xffffffff;
inline constexpr std::uint32_t kWall = 0xfffffffe;

inline bool isBall(std::uint32_t partner) {
  return partner < kWall;
}

}  // namespace wells
