#include "reference/detection.h"

#include <cmath>

namespace wells {

void detectGround(World& world, std::span<Vec3> force, Manifold& manifold) {
  Balls& balls = world.balls;
  const double g = length(world.settings.gravity);
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const double y = balls.position[i].y() - world.arena.center.y();
    if (!(y - balls.radius[i] < 0)) continue;
    manifold.push_back({i, kNoBall, Vec3::UnitY(), balls.radius[i] - y});
    if (std::abs(balls.velocity[i].y()) < kRollingSpeed) {
      balls.velocity[i].y() = 0;
      force[i] -= balls.velocity[i] * (world.settings.friction * balls.mass[i] * g);
    }
  }
}

void detectWall(const World& world, Manifold& manifold) {
  const Balls& balls = world.balls;
  const double R = world.arena.radius;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const double x = balls.position[i].x() - world.arena.center.x();
    const double z = balls.position[i].z() - world.arena.center.z();
    const double squared = x * x + z * z;
    const double reach = R - balls.radius[i];
    if (!(squared >= reach * reach)) continue;
    const double distance = std::sqrt(squared);
    manifold.push_back({i, kNoBall, Vec3{-x / distance, 0, -z / distance}, distance - R});
  }
}

void detectPairs(const World& world, TouchingPairs& pairs, Manifold& manifold) {
  const Balls& balls = world.balls;
  for (const auto& [i, j] : pairs.find(balls)) {
    const Vec3 apart = balls.position[i] - balls.position[j];
    const double d = length(apart);
    const Vec3 normal = d > 0 ? Vec3{apart / d} : Vec3{0, i < j ? 1.0 : -1.0, 0};
    manifold.push_back({i, j, normal, balls.radius[i] + balls.radius[j] - d});
  }
}

}  // namespace wells
