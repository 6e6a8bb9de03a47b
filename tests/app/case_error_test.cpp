// The errors of a run, on worlds that are moved by hand.
#include "case_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wells {
namespace {

/// Two balls of 2 kg and radius 0.5 m at rest, 3 m apart, 1 m above the ground: 4 * 9.81 J.
World twoBalls() {
  World world;
  world.balls.add({.position = {0, 1, 0}}, 0.5, 2);
  world.balls.add({.position = {3, 1, 0}}, 0.5, 2);
  return world;
}

TEST(CaseError, EnergyIsTheRootMeanSquareOfAllStatesThatBeginAStep) {
  const AccuracyCase answer{"", "", 1, {}, ErrorKind::Energy};
  World world = twoBalls();
  CaseError error(answer, world);
  error.beginStep(world);
  world.balls.velocity[0] = {3, 0, 0};  // 9 J more
  error.beginStep(world);
  error.beginStep(world);
  world.balls.velocity[1] = {100, 0, 0};  // at the end alone
  EXPECT_NEAR(error.atTheEnd(world), std::sqrt(2 * 81 / 3.0) / (4 * 9.81), 1e-14);
}

TEST(CaseError, PenetrationIsTheMeanOfTheSumOfSquares) {
  const AccuracyCase answer{"", "", 1, {}, ErrorKind::Penetration};
  World world = twoBalls();
  CaseError error(answer, world);
  error.beginStep(world);
  world.balls.position = {{0, 0.3, 0}, {0.6, 0.3, 0}};  // 0.2 m deep each, 0.4 m into each other
  error.beginStep(world);
  world.balls.position = {{0, 1, 0}, {0, 1, 0}};  // at the end alone
  EXPECT_NEAR(error.atTheEnd(world), (2 * 0.04 + 0.16) / 2, 1e-15);
}

TEST(CaseError, PositionIsThatOfTheEnd) {
  const AccuracyCase answer{"", "", 1, {{1, {3, 1, 2}}}};
  World world = twoBalls();
  CaseError error(answer, world);
  error.beginStep(world);
  world.balls.position[1] = {3, 1, 0.5};
  EXPECT_NEAR(error.atTheEnd(world), 1.5, 1e-15);
}

TEST(CaseError, DeformationIsTheLargestChangeOfADistanceOrAHeight) {
  const AccuracyCase answer{"", "", 1, {}, ErrorKind::Deformation};
  World world = twoBalls();
  const CaseError error(answer, world);
  world.balls.position = {{7, 1, 7}, {7, 1, 10}};  // turned and moved as a whole
  EXPECT_NEAR(error.atTheEnd(world), 0, 1e-15);
  world.balls.position[1].z() = 10.25;
  EXPECT_NEAR(error.atTheEnd(world), 0.25, 1e-15);
  for (Vec3& position : world.balls.position) position.y() = 0.5;
  EXPECT_NEAR(error.atTheEnd(world), 0.5, 1e-15);
}

TEST(CaseError, EndEnergyIsRelativeToWhatItMustBe) {
  const AccuracyCase answer{"", "", 1, {}, ErrorKind::EndEnergy, 8};
  World world = twoBalls();
  const CaseError error(answer, world);
  world.balls.velocity[1] = {0, 3, 0};  // 9 J
  EXPECT_NEAR(error.atTheEnd(world), 0.125, 1e-15);
}

TEST(CaseError, IsInfiniteWhereABallIsNotFinite) {
  for (const ErrorKind kind : {ErrorKind::Position, ErrorKind::Energy, ErrorKind::Penetration,
                               ErrorKind::Deformation, ErrorKind::EndEnergy}) {
    const AccuracyCase answer{"", "", 1, {{0, {0, 1, 0}}}, kind};
    World world = twoBalls();
    CaseError error(answer, world);
    error.beginStep(world);
    world.balls.position[0].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isinf(error.atTheEnd(world))) << describe(kind);
  }
}

}  // namespace
}  // namespace wells
