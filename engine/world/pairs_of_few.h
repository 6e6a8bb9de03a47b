// All pairs among few spheres that overlap, by looking at each: cheaper than any broadphase.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "broadphase/ball_pair.h"
#include "math/vector.h"

namespace wells {

/// Spheres, a row for each number.
struct FewSpheres {
  static constexpr std::size_t kMost = 48;
  // Vector code reads whole vectors from anywhere.
  using Row = std::array<double, kMost + 8>;

  std::size_t count = 0;
  std::array<std::uint32_t, kMost> id{};  // rising
  Row x{}, y{}, z{};                      // m
  Row radius{};                           // m; overlaps none where it is not finite

  /// While count < kMost.
  void add(std::uint32_t ball, const Vec3& center, double ballRadius) {
    id[count] = ball;
    x[count] = center.x();
    y[count] = center.y();
    z[count] = center.z();
    radius[count++] = ballRadius;
  }
};

/// Sets `pairs` to those that overlap, by (a, b).
void findPairsOfFew(const FewSpheres& spheres, std::vector<BallPair>& pairs);

}  // namespace wells
