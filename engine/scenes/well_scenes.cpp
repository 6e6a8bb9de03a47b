#include "scenes/well_scenes.h"

#include <cmath>

#include "scenes/unit_balls.h"

namespace wells {
namespace {

void addWell(World& world, const Vec3& position, double strength) {
  world.tracks.push_back({.keyframes = {{0, position, strength}}, .softening = 2});
}

World highWell() {
  World world = freeWorld();
  addWell(world, {0, 20, 0}, 1000);
  return world;
}

}  // namespace

World makeOrbit(std::size_t, std::uint64_t) {
  World world = highWell();
  addUnitBall(world, {10, 20, 0}, {0, 0, 6});
  return world;
}

World makeCircularOrbit(std::size_t, std::uint64_t) {
  World world = highWell();
  const double s2 = 10 * 10 + 2 * 2;
  addUnitBall(world, {10, 20, 0}, {0, 0, std::sqrt(1000 * 10 * 10 / (s2 * std::sqrt(s2)))});
  return world;
}

World makeThroughTheCentre(std::size_t, std::uint64_t) {
  World world = highWell();
  addUnitBall(world, {0.01, 20, 0});
  return world;
}

World makeWellBounces(std::size_t, std::uint64_t) {
  World world;
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  addWell(world, {0, 3, 0}, 50);
  addUnitBall(world, {4, 3, 0});
  return world;
}

}  // namespace wells
