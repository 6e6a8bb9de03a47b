#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "broadphase/grid_broadphase.h"
#include "math/random.h"
#include "math/vector.h"

namespace wells {
namespace {

using IdPairs = std::set<std::pair<int, int>>;

// Pairs of spheres with gaps down to what double precision tells apart, and of both signs, far from
// the origin: whatever the grid decides in single precision, narrowed it has those that overlap.
TEST(GridOfSpheres, TellsSpheresApartThatNearlyTouch) {
  struct Sphere {
    Vec3 center;
    double radius;
  };
  std::vector<Sphere> spheres;
  Random random(11);
  const auto between = [&](double low, double high) { return random.uniform(low, high); };
  for (int pair = 0; pair < 2000; ++pair) {
    const double radius = between(0.3, 0.5);
    const Vec3 center(300 + between(0, 60), between(0, 60), 700 + between(0, 60));
    const Vec3 way = Vec3(between(-1, 1), between(-1, 1), between(-1, 1) + (pair % 2 == 0 ? 2 : -2))
                         .normalized();
    const double gap = (pair % 4 < 2 ? 1 : -1) * std::pow(10, between(-13, -2));
    spheres.push_back({center, radius});
    spheres.push_back({center + (2 * radius + gap) * way, radius});
  }
  const auto doOverlap = [&](std::uint32_t x, std::uint32_t y) {
    const double bound = spheres[x].radius + spheres[y].radius;
    return squaredLength(spheres[y].center - spheres[x].center) <= bound * bound;
  };
  GridBroadphase flat(nullptr, BoxContent::Spheres);
  for (std::uint32_t i = 0; i < spheres.size(); ++i) {
    const auto& [center, radius] = spheres[i];
    const Vec3 half = Vec3::Constant(radius);
    flat.createProxy(toBullet(center - half), toBullet(center + half), 0, asClient(i), 1, 1,
                     nullptr);
  }
  flat.calculateOverlappingPairs(nullptr);
  std::size_t asked = 0;
  flat.narrow([&](std::uint32_t x, std::uint32_t y) {
    ++asked;
    return doOverlap(x, y);
  });
  IdPairs found;
  std::size_t count = 0;
  for (std::size_t range = 0; range < flat.ranges(); ++range)
    flat.forEachPairIn(range, [&](std::uint32_t x, std::uint32_t y) {
      found.insert(std::minmax(static_cast<int>(x), static_cast<int>(y)));
      ++count;
    });
  IdPairs expected;
  for (std::uint32_t x = 0; x < spheres.size(); ++x)
    for (std::uint32_t y = x + 1; y < spheres.size(); ++y)
      if (doOverlap(x, y)) expected.insert({static_cast<int>(x), static_cast<int>(y)});
  EXPECT_EQ(found, expected);
  EXPECT_EQ(count, expected.size());
  EXPECT_GT(asked, 1000u);
  EXPECT_GT(expected.size(), 1000u);
}

}  // namespace
}  // namespace wells
