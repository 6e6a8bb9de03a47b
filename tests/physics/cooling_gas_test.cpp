// A gas that cools because its impacts take energy, against Haff's law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenes/unit_balls.h"
#include "support/gas_measures.h"
#include "support/gas_theory.h"
#include "support/run_world.h"

namespace wells {
namespace {

// The law has Maxwell's speeds and no memory of earlier impacts. The true speeds keep the gas 0.3 %
// warmer after 30 hits a ball (van Noije & Ernst, Granular Matter 1 (1998) 57), and that balls
// which were hit move alike, another 1 % (0.4 % at eta = 0.02), the more the wider the box: 1.8 %
// in all with 864 balls. In a box of 28 m shear flows would outlive the heat (they decay as nu k^2,
// thermal speeds as rate (1 - e^2)/6), so this one has 11 m. The standard error is 0.25 % after 30
// hits.
TEST(CoolingGas, FollowsHaffsLaw) {
  constexpr double kEta = 0.1, kElasticity = 0.9;
  constexpr std::array kHitsPerBall = {1, 5, 10, 15, 20, 25, 30};
  const double density = kEta / theory::packing(1);
  const std::vector<Sample> ratios = measureCooling(density, kElasticity, 256, 96, kHitsPerBall);
  for (std::size_t k = 0; k < ratios.size(); ++k)
    EXPECT_NEAR(ratios[k].mean(), 1, 0.02)
        << kHitsPerBall[k] << " hits a ball, +- " << ratios[k].standardError();
}

// The same gas in the arena, with nothing around it: before news of the surface arrives, 7 m deep
// within 1 s at speeds of 1 m/s, the inside must have gone through the impacts that the box has, to
// rounding (1e-15 m, magnified about tenfold by each of the few impacts of a ball). In long steps,
// too, in which most balls hang together by possible impacts.
TEST(CoolingGas, IsTheSameInTheArena) {
  constexpr std::uint32_t kBalls = 8788;
  constexpr double kElasticity = 0.9, kDepth = 7, kHeight = 200;
  PeriodicGas gas(kBalls, 0.1 / theory::packing(1), 1);
  settle(gas);
  gas.setElasticity(kElasticity);
  World start = freeWorld();
  start.arena.radius = 200;
  start.settings.elasticity = kElasticity;
  std::vector<std::uint32_t> inside;
  for (std::uint32_t i = 0; i < kBalls; ++i) {
    const Vec3 x = gas.positionOf(i);
    addUnitBall(start, x + Vec3(0, kHeight, 0), gas.balls().velocity[i]);
    if (x.minCoeff() > kDepth && x.maxCoeff() < gas.side() - kDepth) inside.push_back(i);
  }
  EXPECT_GT(inside.size(), 1500u);
  const std::int64_t before = gas.hits();
  gas.runToTime(gas.time() + 1);
  EXPECT_GT(gas.hits() - before, kBalls / 2);
  for (const double dt : {1.0 / 60, 1.0 / 12, 0.25}) {
    World world = start;
    world.settings.dt = dt;
    EXPECT_EQ(runFor(world, 1).substepBalls, 0) << dt;
    for (const std::uint32_t i : inside) {
      Vec3 off = world.balls.position[i] - Vec3(0, kHeight, 0) - gas.positionOf(i);
      for (int k = 0; k < 3; ++k) off[k] -= gas.side() * std::round(off[k] / gas.side());
      ASSERT_LE(length(off), 1e-8) << i << ", dt " << dt;
      ASSERT_LE(length(world.balls.velocity[i] - gas.balls().velocity[i]), 1e-8) << i;
    }
  }
}

}  // namespace
}  // namespace wells
