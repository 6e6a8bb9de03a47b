// SimBenchmark's scenes under its own measures of error, written down here again: over the states
// with which the steps begin, energy and overlaps of all pairs. The best that it reports: bouncing
// 5.7e-4 and elastic-666 6.6e-2 at dt = 0.01 s, 666 1.4e-4 m^2 at dt = 0.001 s (all RaiSim).
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/catalogue.h"
#include "support/run_world.h"

namespace wells {
namespace {

/// Without spin, which smooth ground gives nobody.
double energy(const World& world) {
  double sum = 0;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    sum += world.balls.mass[i] *
           (world.balls.velocity[i].squaredNorm() / 2 + 9.81 * world.balls.position[i].y());
  return sum;
}

double squaredOverlaps(const World& world) {
  const auto square = [](double overlap) { return overlap > 0 ? overlap * overlap : 0; };
  const Balls& b = world.balls;
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    sum += square(b.radius[i] - b.position[i].y());
    for (std::size_t j = i + 1; j < b.size(); ++j)
      sum += square(b.radius[i] + b.radius[j] - (b.position[i] - b.position[j]).norm());
  }
  return sum;
}

struct Result {
  double energyError = 0;  // relative root mean square
  double penetration = 0;  // m^2, mean
  double furthest = 0;     // m, of a centre from the axis
  double highestEnd = 0;   // m, of a centre
};

Result simulate(const char* scene, std::uint64_t seed, double dt, double duration) {
  World world = makeScene(findScene(scene), 0, seed);
  world.settings.dt = dt;
  const auto steps = std::llround(duration / dt);
  const double start = energy(world);
  const auto simulation = makeSimulation();
  Result result;
  for (std::int64_t step = 0; step < steps; ++step) {
    result.energyError += std::pow(energy(world) - start, 2) / static_cast<double>(steps);
    result.penetration += squaredOverlaps(world) / static_cast<double>(steps);
    simulation->step(world);
  }
  result.energyError = std::sqrt(result.energyError) / start;
  for (const Vec3& x : world.balls.position) {
    result.furthest = std::max(result.furthest, std::hypot(x.x(), x.z()));
    result.highestEnd = std::max(result.highestEnd, x.y());
  }
  return result;
}

TEST(SimBenchmark, BouncingKeepsTheEnergy) {
  EXPECT_LE(simulate("bouncing", 1, 0.01, 20).energyError, 1e-10);
}

TEST(SimBenchmark, ElasticBlockKeepsTheEnergy) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Result result = simulate("elastic-666", seed, 0.01, 10);
    EXPECT_LE(result.energyError, 1e-9) << seed;
    EXPECT_GT(result.furthest, 10) << seed << ": no collapse";
    EXPECT_LT(result.furthest, 249) << seed << ": the wall is in the way";
  }
}

// Balls are thrown out of the block's midst, much faster than they came, within steps in which many
// others meet: also then nobody is left to substeps.
TEST(SimBenchmark, ElasticBlockKeepsTheEnergyAtCoarseSteps) {
  for (const double dt : {1.0 / 60, 1.0 / 30, 2.0 / 15})
    EXPECT_LE(simulate("elastic-666", 1, dt, 10).energyError, 1e-9) << dt;
}

TEST(SimBenchmark, BlockHardlyOverlaps) {
  const Result result = simulate("666", 1, 0.001, 10);
  EXPECT_LE(result.penetration, 1e-6);
  EXPECT_GT(result.penetration, 0) << "no heap at all";
  EXPECT_NEAR(result.highestEnd, 0.1, 1e-6) << "all have come down";
  EXPECT_LT(result.furthest, 249) << "the wall is in the way";
}

}  // namespace
}  // namespace wells
