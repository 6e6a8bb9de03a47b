#include "scenes/sim_benchmark.h"

#include "math/random.h"

namespace wells {
namespace {

constexpr double kRadius = 0.1;  // m
constexpr double kMass = 10;     // kg

World smoothGround(double elasticity) {
  World world;
  world.arena.radius = 250;
  world.settings.elasticity = elasticity;
  world.settings.friction = 0;
  return world;
}

World block(double elasticity, double lowest, std::uint64_t seed) {
  constexpr int kEdge = 6;
  constexpr double kSpacing = 0.21;       // m
  constexpr double kPerturbation = 1e-3;  // m
  constexpr double kHalf = 0.5 * (kEdge - 1);
  World world = smoothGround(elasticity);
  Random random(seed);
  for (int i = 0; i < kEdge; ++i)
    for (int j = 0; j < kEdge; ++j)
      for (int k = 0; k < kEdge; ++k) {
        const double dx = random.uniform(0, kPerturbation);
        const double dy = random.uniform(0, kPerturbation);
        const double dz = random.uniform(0, kPerturbation);
        world.balls.add({.position = Vec3{(i - kHalf) * kSpacing + dx, lowest + j * kSpacing + dy,
                                          (k - kHalf) * kSpacing + dz}},
                        kRadius, kMass);
      }
  return world;
}

}  // namespace

World makeBouncing(std::size_t, std::uint64_t) {
  World world = smoothGround(1);
  for (int i = -3; i <= 3; ++i)
    for (int k = -3; k <= 3; ++k)
      world.balls.add({.position = Vec3{2.0 * i, 5, 2.0 * k}}, kRadius, kMass);
  return world;
}

World makeBlock(std::size_t, std::uint64_t seed) {
  return block(0, 0.101, seed);
}

World makeElasticBlock(std::size_t, std::uint64_t seed) {
  return block(1, 1.101, seed);
}

}  // namespace wells
