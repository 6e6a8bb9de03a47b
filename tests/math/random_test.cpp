#include "math/random.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

// First outputs for seed 1234567 of Vigna's reference implementation, as widely published.
TEST(Random, SplitmixGivesThePublishedNumbers) {
  std::uint64_t state = 1234567;
  EXPECT_EQ(splitmix64(state), 6457827717110365317u);
  EXPECT_EQ(splitmix64(state), 3203168211198807973u);
  EXPECT_EQ(splitmix64(state), 9817491932198370423u);
}

// Moments of the uniform distribution, five standard errors wide.
TEST(Random, UniformHasItsMoments) {
  Random random(1);
  constexpr int kCount = 1000000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.uniform();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 5 * std::sqrt(1.0 / 12 / kCount));
  EXPECT_NEAR(squares / kCount, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kCount));
}

TEST(Random, DirectionsAreUnitVectorsWithoutPreference) {
  Random random(2);
  constexpr int kCount = 100000;
  Vec3 sum = Vec3::Zero();
  Vec3 squares = Vec3::Zero();
  for (int i = 0; i < kCount; ++i) {
    const Vec3 d = random.direction();
    ASSERT_NEAR(length(d), 1, 1e-15);
    sum += d;
    squares += d.cwiseProduct(d);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum[axis] / kCount, 0, 5 * std::sqrt(1.0 / 3 / kCount));
    EXPECT_NEAR(squares[axis] / kCount, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kCount));
  }
}

TEST(Random, BelowCoversItsRangeEvenly) {
  Random random(3);
  std::array<int, 7> counts{};
  constexpr int kCount = 70000;
  for (int i = 0; i < kCount; ++i) ++counts.at(random.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 5 * std::sqrt(10000.0));
}

}  // namespace
}  // namespace wells
