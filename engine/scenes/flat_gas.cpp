#include "scenes/flat_gas.h"

#include <cmath>

#include "math/random.h"
#include "scenes/scatter.h"
#include "scenes/unit_balls.h"

namespace wells {
namespace {

constexpr double kSpeed = 5;  // m/s

/// Uniform on the unit circle, by rejection from the square.
Vec3 horizontalDirection(Random& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), 0, random.uniform(-1, 1)};
    const double squared = squaredLength(v);
    if (squared > 1e-4 && squared <= 1) return v / std::sqrt(squared);
  }
}

}  // namespace

World makeFlatGas(std::size_t balls, std::uint64_t seed) {
  World world = freeWorld();
  world.arena.radius = 80 * std::sqrt(static_cast<double>(balls) / 4000);
  scatterBalls(world, balls, 0.5, 1, seed);
  Random random(~seed);
  for (std::size_t i = 0; i < balls; ++i) {
    world.balls.position[i].y() = 1;
    world.balls.velocity[i] = kSpeed * horizontalDirection(random);
  }
  return world;
}

World makeCoolingGas(std::size_t balls, std::uint64_t seed) {
  World world = makeFlatGas(balls, seed);
  world.settings.elasticity = 0.9;
  return world;
}

}  // namespace wells
