#include "scenes/crowds.h"

#include <cmath>

#include "math/random.h"
#include "scenes/own_well.h"
#include "scenes/scatter.h"

namespace wells {
namespace {

constexpr double kRadius = 0.5;  // m
constexpr double kMass = 1;      // kg

double scaledRadius(double radiusAtTenThousand, std::size_t balls) {
  return radiusAtTenThousand * std::sqrt(static_cast<double>(balls) / 10000);
}

/// Calls place(x, layer, z) for lattice sites inside the disc |(x, z)| < limit, row by row and
/// layer by layer, until `count` sites have been given out.
template <class Place>
void forLatticeSites(std::size_t count, double spacing, double limit, Place place) {
  const int half = static_cast<int>(limit / spacing) + 1;
  std::size_t placed = 0;
  for (int layer = 0; placed < count; ++layer)
    for (int i = -half; i <= half; ++i)
      for (int j = -half; j <= half && placed < count; ++j) {
        const double x = i * spacing;
        const double z = j * spacing;
        // The axis itself is always a site, so that every layer takes at least one ball.
        if ((i != 0 || j != 0) && std::sqrt(x * x + z * z) >= limit) continue;
        place(x, layer, z);
        ++placed;
      }
}

}  // namespace

World makeWellsCrowd(std::size_t balls, std::uint64_t seed) {
  World world;
  const double arenaRadius = balls == 25 ? 40 : scaledRadius(40, balls);
  world.arena.radius = arenaRadius;
  world.settings.elasticity = 0.8;
  world.settings.friction = 0.3;
  const double strength = 9.81 * arenaRadius * arenaRadius / 8;
  const double half = arenaRadius / 2;
  for (const Vec3& position :
       {Vec3{half, 1, 0}, Vec3{-half, 1, 0}, Vec3{0, 1, half}, Vec3{0, 1, -half}})
    world.tracks.push_back({.keyframes = {{0, position, strength}}, .softening = 2});

  Random random(seed);
  forLatticeSites(balls, 1.2, arenaRadius - 1, [&](double x, int layer, double z) {
    const double dx = random.uniform(-0.05, 0.05);
    const double dy = random.uniform(-0.05, 0.05);
    const double dz = random.uniform(-0.05, 0.05);
    world.balls.add({.position = Vec3{x + dx, 1 + 1.2 * layer + dy, z + dz}}, kRadius, kMass);
  });
  return world;
}

World makeGas(std::size_t balls, std::uint64_t seed) {
  World world;
  world.arena.radius = scaledRadius(80, balls);
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  Random random(seed);
  forLatticeSites(balls, 2.4, world.arena.radius - 1, [&](double x, int layer, double z) {
    world.balls.add({.position = Vec3{x, 1 + 2.4 * layer, z}, .velocity = 5 * random.direction()},
                    kRadius, kMass);
  });
  return world;
}

World makeSettledLayer(std::size_t balls, std::uint64_t) {
  World world;
  world.arena.radius = scaledRadius(80, balls);
  world.settings.elasticity = 0;
  world.settings.friction = 0.5;
  forLatticeSites(balls, 1.2, world.arena.radius - 1, [&](double x, int layer, double z) {
    world.balls.add({.position = Vec3{x, kRadius + 1.2 * layer, z}}, kRadius, kMass);
  });
  return world;
}

World makeTemplateWorld(std::size_t balls, std::uint64_t seed) {
  World world;
  world.settings.elasticity = 0.8;
  world.settings.friction = 0.995;
  world.tracks.push_back(defaultWell(world.arena, kRadius, PeerId{1}));
  scatterBalls(world, balls, kRadius, kMass, seed);
  return world;
}

}  // namespace wells
