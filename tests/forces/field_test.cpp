#include "forces/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forces/pull_bound.h"
#include "math/instruction_set.h"
#include "math/random.h"

namespace wells {
namespace {

Field someField() {
  return {.gravity = {0, -9.81, 0},
          .wells = {{.position = {3, 1, 0}, .strength = 200, .softening = 2},
                    {.position = {-5, 2, 4}, .strength = -80, .softening = 0.5}}};
}

// Plummer: one well of strength S at distance d pulls S d / (d^2 + eps^2)^(3/2).
TEST(Field, OneWellPullsByTheSoftenedLaw) {
  const Field field{.wells = {{.position = {0, 0, 0}, .strength = 1000, .softening = 2}}};
  const Vec3 a = acceleration(field, {0, 0, -4}, 0);
  EXPECT_NEAR(a.z(), 1000 * 4 / std::pow(20, 1.5), 1e-12);
  EXPECT_EQ(a.x(), 0);
  EXPECT_EQ(a.y(), 0);
  EXPECT_EQ(acceleration(field, {0, 0, 0}, 0), Vec3(0, 0, 0));
  EXPECT_NEAR(potential(field, {0, 0, -4}, Vec3::Zero()), -1000 / std::sqrt(20.0), 1e-12);
}

// The force is minus the gradient of the potential: central differences, error ~ step^2.
TEST(Field, AccelerationIsMinusTheGradientOfThePotential) {
  const Field field = someField();
  Random random(1);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const Vec3 x{random.uniform(-9, 9), random.uniform(0, 9), random.uniform(-9, 9)};
    const Vec3 a = acceleration(field, x, 0);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 shift = Vec3::Zero();
      shift[axis] = kStep;
      const double gradient =
          (potential(field, x + shift, {0, 0, 0}) - potential(field, x - shift, {0, 0, 0})) /
          (2 * kStep);
      EXPECT_NEAR(a[axis], -gradient, 1e-5);
    }
  }
}

TEST(Field, WellsMoveDuringTheStep) {
  Field field = someField();
  Field moved = field;
  Well well = field.wells[0];
  well.velocity = {1, 2, 3};
  field.wells.set(0, well);
  well = moved.wells[0];
  well.position += Vec3(0.5, 1, 1.5);
  moved.wells.set(0, well);
  const Vec3 x{1, 1, 1};
  EXPECT_EQ(acceleration(field, x, 0.5), acceleration(moved, x, 0));
}

/// By a well that is `distance` away from a ball that moves no more than `way`: the law, at the
/// nearest to the place of the strongest pull that it may get.
double pullBoundOf(const Well& well, double distance, double way) {
  const double strongestAt = well.softening / std::sqrt(2.0);
  const double at = std::clamp(strongestAt, std::max(0.0, distance - way), distance + way);
  return std::abs(well.strength) * at / std::pow(at * at + well.softening * well.softening, 1.5);
}

TEST(PullBound, IsTheSumOfWhatEachWellPullsAtTheMost) {
  Random random(2);
  for (const InstructionSet set : instructionSets()) {
    useInstructionSet(set);
    for (int i = 0; i < 500; ++i) {
      const double t = random.uniform(0, 0.1);
      const double duration = random.uniform(0, 0.1);
      const double speed = random.uniform(0, 30);
      const Vec3 x = random.uniform(0, 9) * random.direction();
      Field field;
      double expected = 0;
      for (int n = 0; n < i % 11; ++n) {
        const Well well{.position = random.uniform(0, 9) * random.direction(),
                        .velocity = random.uniform(0, 9) * random.direction(),
                        .strength = random.uniform(-900, 900),
                        .softening = random.uniform(0.1, 9)};
        field.wells.push_back(well);
        expected += pullBoundOf(well, length(well.position + t * well.velocity - x),
                                (speed + length(well.velocity)) * duration);
      }
      ASSERT_NEAR(pullBound(field, x, speed, t, duration), expected, 1e-12 * expected);
    }
  }
  useInstructionSet(instructionSets().back());
}

TEST(Field, WellsThatAreOffAreLeftOut) {
  World world;
  world.tracks = {{.keyframes = {{0, {1, 1, 1}, 0}}}, {.keyframes = {{0, {2, 1, 1}, -3}}}};
  ASSERT_EQ(fieldOf(world).wells.size(), 1u);
  EXPECT_EQ(fieldOf(world).wells[0].strength, -3);
}

TEST(Drag, IsAFactorPerSecond) {
  EXPECT_EQ(dragFactor(1, 0.37), 1);
  EXPECT_NEAR(dragFactor(0.9, 2), 0.81, 1e-15);
  EXPECT_NEAR(dragFactor(0.5, 1.0 / 60), std::pow(0.5, 1.0 / 60), 1e-15);
}

// omega^2 = |S| / softening^3 of the sharpest well; a stretch turns by at most 1/4 rad.
TEST(Stretches, ResolveTheSharpestWell) {
  const Well smooth{.strength = 10, .softening = 2};
  const Well sharp{.strength = -100, .softening = 0.1};  // omega = 316.2 / s
  EXPECT_EQ(stretchesOf({}, 1.0 / 60), 1);
  EXPECT_EQ(stretchesOf({smooth}, 1.0 / 60), 1);
  EXPECT_EQ(stretchesOf({smooth, sharp}, 1.0 / 60), 22);  // 4 x 316.2 / 60 = 21.08
  EXPECT_EQ(stretchesOf({sharp}, 1.0 / 6000), 1);
  EXPECT_EQ(stretchesOf({{.strength = 1e30, .softening = 0.01}}, 1), kMostStretches);
}

TEST(Stretches, AreInTheFieldOfTheStep) {
  World world;
  world.tracks = {{.keyframes = {{0, {0, 3, 0}, 100}}, .softening = 0.1}};
  const Field field = fieldOf(world);
  EXPECT_EQ(field.stretches, 22);
  EXPECT_DOUBLE_EQ(field.stretch, 1.0 / 60 / 22);
  world.tracks[0].keyframes[0].strength = 0;  // off
  EXPECT_EQ(fieldOf(world).stretches, 1);
}

// The rate of the potential at a fixed place, against a difference quotient.
TEST(Potential, ChangesAtTheRateOfItsWells) {
  const Field field{.wells = {{.position = {1, 2, 3}, .velocity = {4, -1, 2}, .strength = 50}}};
  const Vec3 place{-2, 1, 0};
  const double h = 1e-5;
  const double quotient = (potentialAt(field, place, Vec3::Zero(), 0.3 + h) -
                           potentialAt(field, place, Vec3::Zero(), 0.3 - h)) /
                          (2 * h);
  EXPECT_NEAR(potentialRate(field, place, 0.3), quotient, 1e-8);
}

}  // namespace
}  // namespace wells
