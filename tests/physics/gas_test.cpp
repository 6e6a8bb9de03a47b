// Gases of hard balls in a periodic box against the theory of liquids: whether impacts are found,
// happen when they should and share out momentum as they should, millions of times. Times are
// sigma sqrt(m / kT), which is 1 s here: balls of 1 m and 1 kg, kT = 1 J.
#include <gtest/gtest.h>

#include <numbers>

#include "support/gas_measures.h"
#include "support/gas_theory.h"

namespace wells {
namespace {

void expectPressure(double eta, double expected, int settling, std::int64_t hits) {
  const double density = eta / theory::packing(1);
  EXPECT_NEAR(density * theory::carnahanStarling(eta), expected, 1e-6);
  const FluidSamples samples =
      measureFluid({.density = density, .settling = settling, .hits = hits, .seeds = 3});
  EXPECT_NEAR(samples.pressure.mean() / expected, 1, 0.005)
      << "+- " << samples.pressure.standardError() / expected;
}

// P* = P sigma^3 / kT = (6 eta / pi) Z(eta). The standard errors are 0.1 %; the formula itself is
// 0.2 % below simulations at eta = 0.25.
TEST(PeriodicGas, HasThePressureOfAFluid) {
  expectPressure(0.25, 1.467762, 20, 150'000);
}

TEST(PeriodicGas, HasThePressureOfADenseFluid) {
  expectPressure(0.45, 8.065532, 60, 200'000);
}

// A ball is hit hitRate() times a second: 1 / (4 sqrt(pi) 0.5 g(0.2618)).
TEST(PeriodicGas, HasEnskogsFreeTime) {
  EXPECT_NEAR(1 / theory::hitRate(0.5), 0.1305715, 1e-7);
  const FluidSamples samples = measureFluid({.density = 0.5, .hits = 50'000, .seeds = 4});
  EXPECT_NEAR(samples.freeTime.mean() / 0.1305715, 1, 0.01)
      << "+- " << samples.freeTime.standardError() / 0.1305715;
}

// From equal speeds to Maxwell's, within 20 hits a ball.
TEST(PeriodicGas, ComesToMaxwellsSpeeds) {
  Sample before, after;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PeriodicGas gas(2048, 0.5, seed);
    for (const Vec3& v : gas.balls().velocity) before.values.push_back(length(v));
    settle(gas);
    for (const Vec3& v : gas.balls().velocity) after.values.push_back(length(v));
  }
  EXPECT_LE(after.kolmogorovSmirnov(theory::maxwellInSpace), kKolmogorovSmirnov);
  EXPECT_GE(before.kolmogorovSmirnov(theory::maxwellInSpace), 10);
}

}  // namespace
}  // namespace wells
