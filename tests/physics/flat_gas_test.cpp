// A gas of discs in the arena, through the whole engine.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/flat_gas.h"
#include "support/gas_measures.h"
#include "support/gas_theory.h"
#include "support/wall_impulses.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

// 4000 discs of r = 0.5 m in the centres' room of R - r = 79.5 m: eta = N r^2 / (R - r)^2 = 0.1582.
// The wall takes part of a ball's forbidden area upon itself, so that the gas stands denser there
// and the pressure is lower by the order of r/R: by 0.37 % with the line tension of scaled particle
// theory, gamma = n r kT / (1 - eta), in P_wall R = P R - gamma and N = n pi R^2 - 2 pi R
// dgamma/dmu. (With R for R - r in both area and rim eta would be 0.1563, and P A / (N kT) 1.3 %
// larger than with points on the same area.) 33 s, 220,000 impacts: the standard error is 0.5 %,
// and 0.15 % without the sloshing.
TEST(FlatGas, PressesOnTheWallAsHendersonSays) {
  const double expected = theory::henderson(4000 * 0.25 / (79.5 * 79.5));
  EXPECT_NEAR(expected, 1.41567, 1e-5);
  const FlatGas gas = measureFlatGas(1, 120, 2000);
  EXPECT_NEAR(gas.compressibility / expected, 1, 0.02);
  EXPECT_NEAR(gas.steady / expected, 1, 0.01);
  // All began with 5 m/s.
  EXPECT_LE(gas.speeds.kolmogorovSmirnov(theory::maxwellInPlane), kKolmogorovSmirnov);
}

// The plane is kept to the bit, and so is the momentum that the wall's book speaks of.
TEST(FlatGas, StaysFlat) {
  World world = makeFlatGas(4000, 2);
  const auto simulation = makeSimulation();
  ASSERT_TRUE(simulation->openBooks());
  for (int i = 0; i < 60; ++i) {
    simulation->step(world);
    ASSERT_EQ(simulation->counts().latePairs, 0);
    ASSERT_EQ(simulation->counts().substepBalls, 0);
  }
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    ASSERT_EQ(world.balls.position[i].y(), 1);
    ASSERT_EQ(world.balls.velocity[i].y(), 0);
  }
  EXPECT_EQ(length(simulation->books()->ground.linear), 0);
}

// Impacts that take energy, in steps of any length: they have their own times, so that the length
// changes no digit but the last (and those that each of the few impacts of a ball magnifies).
TEST(FlatGas, CoolsAlikeInStepsOfAnyLength) {
  double expected = 0;
  for (const double dt : {1.0 / 60, 0.05, 0.1, 0.2}) {
    World world = makeFlatGas(4000, 3);
    world.settings.elasticity = 0.9;
    world.settings.dt = dt;
    const auto simulation = makeSimulation();
    double energy = kineticEnergy(world.balls);
    const double start = energy;
    for (int i = 0; i < std::lround(1.6 / dt); ++i) {
      simulation->step(world);
      ASSERT_EQ(simulation->counts().substepBalls, 0) << dt;
      const double now = kineticEnergy(world.balls);
      ASSERT_LE(now, energy) << dt;
      energy = now;
    }
    if (expected == 0) expected = energy;
    EXPECT_NEAR(energy / expected, 1, 1e-9) << dt;
    EXPECT_LT(energy, 0.8 * start);
    EXPECT_LE(measure(world).worstOverlap(), 1e-12) << dt;
  }
}

// How the pressure is read, on a world whose hits of the wall are known: two balls that go back and
// forth at 3 and 4 m/s, and a pair in the middle that meets within the first step.
TEST(WallImpulses, AreWhatTheWallGave) {
  World world = makeFlatGas(4, 1);
  world.arena.radius = 10;
  world.settings.dt = 0.25;
  const auto set = [&](std::size_t i, const Vec3& x, const Vec3& v) {
    world.balls.position[i] = x;
    world.balls.velocity[i] = v;
  };
  set(0, {9, 1, 0}, {3, 0, 0});
  set(1, {-9, 1, 0}, {-4, 0, 0});
  set(2, {0, 1, -0.75}, {0, 0, 2});
  set(3, {0, 1, 0.75}, {0, 0, -2});
  const Balls before = world.balls;
  const auto simulation = makeSimulation();
  simulation->step(world);
  EXPECT_EQ(simulation->counts().impacts, 3);
  EXPECT_NEAR(wallImpulses(before, world.balls, world.settings.dt), 2 * 3 + 2 * 4, 1e-12);
}

}  // namespace
}  // namespace wells
