#include "world/reaches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "math/instruction_set.h"
#include "math/random.h"
#include "world/advance.h"

namespace wells {
namespace {

Balls randomBalls(std::size_t count) {
  Random random(5);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i)
    balls.add({.position = 30 * random.direction(),
               .velocity = random.uniform(0, 40) * random.direction(),
               .spin = 5 * random.direction()},
              random.uniform(0.1, 2), 1);
  return balls;
}

class Reaches : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override { useInstructionSet(GetParam()); }
  void TearDown() override { useInstructionSet(instructionSets().back()); }

  const Field field_{.gravity = {0, -9.81, 0.5},
                     .wells = {{.position = {1, 2, 3}, .strength = 500, .softening = 2},
                               {.position = {-9, 2, 3}, .strength = -80, .softening = 1}}};
  static constexpr double kDt = 1.0 / 60;
};

TEST_P(Reaches, HaveTheBitsOfOneBallAtATime) {
  for (const std::size_t count : {1, 3, 8, 63, 64, 65, 200}) {
    const Balls balls = randomBalls(count);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    std::vector<std::uint32_t> some;
    for (std::uint32_t i = 0; i < count; i += 3) some.push_back(i);
    for (const auto& among : {all, some}) {
      std::vector<double> reach(count, -1);
      reachesOf(field_, balls, among, kDt, reach);
      std::vector<double> expected(count, -1);
      for (const std::uint32_t i : among)
        expected[i] = reachOf(field_, balls.state(i), balls.radius[i], kDt);
      EXPECT_EQ(reach, expected) << count << " balls";
    }
  }
}

TEST_P(Reaches, WhatIsNotFiniteHasNoneAndLeavesItsNeighboursTheirs) {
  const std::vector<std::uint32_t> among = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const Balls balls = randomBalls(among.size());
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int component = 0; component < 9; ++component) {
      Balls spoilt = balls;
      auto& vectors = component < 3   ? spoilt.position
                      : component < 6 ? spoilt.velocity
                                      : spoilt.spin;
      vectors[4][component % 3] = wrong;
      std::vector<double> reach(among.size());
      reachesOf(field_, spoilt, among, kDt, reach);
      for (const std::uint32_t i : among) {
        if (i == 4)
          EXPECT_TRUE(std::isnan(reach[i]));
        else
          EXPECT_EQ(reach[i], reachOf(field_, balls.state(i), balls.radius[i], kDt));
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, Reaches, testing::ValuesIn(instructionSets()),
                         [](const auto& tested) { return std::string(name(tested.param)); });

}  // namespace
}  // namespace wells
