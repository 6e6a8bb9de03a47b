#include "contacts/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// The bits of x and z in turn, one by one.
std::uint32_t mortonCode(std::uint32_t x, std::uint32_t z) {
  std::uint32_t code = 0;
  for (std::uint32_t bit = 0; bit < 16; ++bit)
    code |= (x >> bit & 1) << (2 * bit) | (z >> bit & 1) << (2 * bit + 1);
  return code;
}

// Balls that touch, in a square: columns are 2 m wide, four radii, and hold four balls each.
TEST(SpatialOrder, GoesAlongTheCurve) {
  constexpr std::uint32_t kSide = 64;
  Balls balls;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    balls.add({.position = Vec3(-7 + static_cast<double>(i % kSide), 0, i / kSide)}, 0.5, 1);
  Ids expected = all(balls);
  std::ranges::stable_sort(
      expected, {}, [](std::uint32_t i) { return mortonCode(i % kSide / 2, i / kSide / 2); });
  EXPECT_EQ(sorted(balls, all(balls)), expected);
}

}  // namespace
}  // namespace wells
