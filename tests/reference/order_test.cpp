// Observed orders of convergence on a softened orbit in free space.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/reference.h"

namespace wells {
namespace {

// Well at (0, 20, 0), S = 1000, softening 2 m, no gravity; from (10, 20, 0) with 6 m/s along z.
World orbit(double dt) {
  World world;
  world.settings.dt = dt;
  world.settings.gravity = Vec3::Zero();
  world.tracks = {{.keyframes = {{.position = {0, 20, 0}, .strength = 1000}}, .softening = 2}};
  world.balls.add({.position = {10, 20, 0}, .velocity = {0, 0, 6}}, 0.5, 1);
  return world;
}

/// Distance (m) from the exact place after 2 s, (-2.653257440958655, -5.234073690852200) in (x, z):
/// the limit of extrapolated integrations with ever smaller steps.
double errorOfOrbit(ReferenceVariant variant, int stepsPerSecond) {
  World world = orbit(1.0 / stepsPerSecond);
  const auto stepper = makeReference(variant);
  for (int i = 0; i < 2 * stepsPerSecond; ++i) stepper->step(world);
  return length(world.balls.position[0] - Vec3{-2.653257440958655, 20, -5.234073690852200});
}

/// Least-squares slope of log(error) over log(dt).
double fittedOrder(ReferenceVariant variant, const std::vector<int>& stepsPerSecond) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const int n : stepsPerSecond) {
    const double logDt = -std::log(n);
    const double logError = std::log(errorOfOrbit(variant, n));
    x += logDt;
    y += logError;
    xx += logDt * logDt;
    xy += logDt * logError;
  }
  const double count = static_cast<double>(stepsPerSecond.size());
  return (count * xy - x * y) / (count * xx - x * x);
}

TEST(ReferenceOrder, EulerIsFirstOrder) {
  EXPECT_NEAR(fittedOrder(ReferenceVariant::Euler, {512, 1024, 2048, 4096}), 1, 0.1);
}

TEST(ReferenceFlaws, ImprovedEulerIsOfFirstOrderOnly) {
  EXPECT_NEAR(fittedOrder(ReferenceVariant::ImprovedEuler, {512, 1024, 2048, 4096}), 1, 0.1);
}

TEST(ReferenceOrder, HeunIsSecondOrder) {
  EXPECT_NEAR(fittedOrder(ReferenceVariant::Heun, {512, 1024, 2048, 4096}), 2, 0.1);
}

TEST(ReferenceOrder, TextbookRungeKuttaIsFourthOrder) {
  EXPECT_NEAR(fittedOrder(ReferenceVariant::Rk4, {128, 256, 512, 1024}), 4, 0.1);
}

TEST(ReferenceFlaws, PublishedRungeKuttaDoesNotConverge) {
  EXPECT_NEAR(fittedOrder(ReferenceVariant::RungeKutta, {1024, 2048, 4096}), 0, 0.1);
  EXPECT_GT(errorOfOrbit(ReferenceVariant::RungeKutta, 4096), 1);
}

}  // namespace
}  // namespace wells
