#include "contacts/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

using Ids = std::vector<std::uint32_t>;

Balls scattered(std::size_t count, double range) {
  Random random(11);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i)
    balls.add({.position = random.uniform(0, range) * random.direction()}, random.uniform(0.1, 0.5),
              1);
  return balls;
}

Ids all(const Balls& balls) {
  Ids ids(balls.size());
  std::iota(ids.begin(), ids.end(), 0u);
  return ids;
}

Ids sorted(const Balls& balls, const Ids& ids) {
  SpatialOrder order;
  order.sort(balls, ids);
  return {order.ids().begin(), order.ids().end()};
}

void expectPermutation(const Balls& balls, const Ids& ids) {
  Ids result = sorted(balls, ids);
  std::ranges::sort(result);
  EXPECT_EQ(result, ids);
}

TEST(SpatialOrder, HasEachBallOnce) {
  for (const std::size_t count : {1, 2, 3, 64, 1000})
    for (const double range : {0.0, 1e-9, 1.0, 40.0, 1e9, 1e300}) {
      const Balls balls = scattered(count, range);
      expectPermutation(balls, all(balls));
    }
}

TEST(SpatialOrder, TakesBallsThatFarFromAllOthers) {
  Balls balls = scattered(200, 10);
  for (const double far : {1e9, -1e9, 1e300, -1e300}) {
    balls.position[70] = {far, 0, 0};
    balls.position[71] = {0, far, 0};
    balls.position[72] = {0, 0, far};
    expectPermutation(balls, all(balls));
  }
}

TEST(SpatialOrder, KeepsTheOrderOfIdsWhereAllAreInOnePlace) {
  Balls balls = scattered(100, 10);
  for (Vec3& at : balls.position) at = {3, 1, -2};
  EXPECT_EQ(sorted(balls, all(balls)), all(balls));
}

TEST(SpatialOrder, SortsThoseGivenAlone) {
  const Balls balls = scattered(300, 10);
  Ids some;
  for (std::uint32_t i = 1; i < 300; i += 7) some.push_back(i);
  expectPermutation(balls, some);
}

TEST(SpatialOrder, DependsOnPositionsAndIdsAlone) {
  Balls balls = scattered(500, 20);
  const Ids first = sorted(balls, all(balls));
  SpatialOrder used;
  used.sort(scattered(3000, 100), all(scattered(3000, 100)));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls.velocity[i] = {1, 2, 3};
    balls.spin[i] = {4, 5, 6};
    balls.mass[i] = 7;
  }
  used.sort(balls, all(balls));
  EXPECT_EQ(Ids(used.ids().begin(), used.ids().end()), first);
}

// A regular square of balls that touch: along the curve most neighbours are near each other in the
// order, in any stretch of a square of columns; by ids, rows of 64 would be apart.
TEST(SpatialOrder, KeepsNeighboursTogether) {
  constexpr std::uint32_t kSide = 64;
  constexpr std::uint32_t kStretch = 512;
  Balls balls;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    balls.add({.position = Vec3(i % kSide, 0, i / kSide)}, 0.5, 1);
  const Ids order = sorted(balls, all(balls));
  Ids placeOf(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) placeOf[order[k]] = k;
  std::uint32_t pairs = 0, within = 0;
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    ++pairs;
    within += placeOf[i] / kStretch == placeOf[j] / kStretch ? 1 : 0;
  };
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    if (i % kSide + 1 < kSide) add(i, i + 1);
    if (i + kSide < kSide * kSide) add(i, i + kSide);
  }
  EXPECT_GT(within, 0.9 * pairs);
}

}  // namespace
}  // namespace wells
