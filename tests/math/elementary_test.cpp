#include "math/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/random.h"

namespace wells {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

// The C library's functions are correct to about one unit in the last place: an independent
// reference.
TEST(Elementary, SineAndCosineAgreeWithTheCLibrary) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double turns = random.uniform(-0.125, 0.125);
    const SinCos angle = sinCosOfTurns(turns);
    EXPECT_NEAR(angle.sin, std::sin(2 * kPi * turns), 4 * kUlp);
    EXPECT_NEAR(angle.cos, std::cos(2 * kPi * turns), 4 * kUlp);
  }
}

TEST(Elementary, TurnsReduceExactly) {
  for (const double whole : {0.0, 1.0, -3.0, 1048576.0}) {
    EXPECT_EQ(sinCosOfTurns(whole).sin, 0);
    EXPECT_EQ(sinCosOfTurns(whole).cos, 1);
    EXPECT_EQ(sinCosOfTurns(whole + 0.25).sin, 1);
    EXPECT_EQ(sinCosOfTurns(whole + 0.25).cos, 0);
    EXPECT_EQ(sinCosOfTurns(whole + 0.5).cos, -1);
    EXPECT_EQ(sinCosOfTurns(whole + 0.75).sin, -1);
    // 1/8 turn survives the addition in full.
    EXPECT_EQ(sinCosOfTurns(whole + 0.125).sin, sinCosOfTurns(0.125).sin);
  }
}

TEST(Elementary, ExponentialAgreesWithTheCLibrary) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-600, 600);
    EXPECT_NEAR(exponential(x) / std::exp(x), 1, 4 * kUlp * (1 + std::abs(x) * 1e-2)) << x;
  }
  EXPECT_EQ(exponential(0), 1);
}

TEST(Elementary, LogarithmAgreesWithTheCLibrary) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const double x = exponential(random.uniform(-600, 600));
    EXPECT_NEAR(naturalLogarithm(x), std::log(x), 4 * kUlp * (1 + std::abs(std::log(x)))) << x;
  }
  EXPECT_EQ(naturalLogarithm(1), 0);
}

}  // namespace
}  // namespace wells
