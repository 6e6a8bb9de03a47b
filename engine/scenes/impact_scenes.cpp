#include "scenes/impact_scenes.h"

#include <cmath>

#include "scenes/unit_balls.h"

namespace wells {
namespace {

World roughWorld() {
  World world = freeWorld();
  world.settings.elasticity = 0.8;
  world.settings.friction = 0.3;
  return world;
}

World threeInARow(double elasticity) {
  World world = freeWorld();
  world.settings.elasticity = elasticity;
  addUnitBall(world, {0, 1, 0}, {1, 0, 0});
  addUnitBall(world, {2, 1, 0});
  addUnitBall(world, {3.5, 1, 0});
  return world;
}

}  // namespace

World makeObliqueBalls(std::size_t, std::uint64_t) {
  World world = freeWorld();
  addUnitBall(world, {0, 1, 0}, {5, 0, 0});
  addUnitBall(world, {3, 1, 0.4});
  return world;
}

World makeFrictionBallsStick(std::size_t, std::uint64_t) {
  World world = roughWorld();
  // They touch when A is at (0, 1, 0), with the normal (cos 30, 0, sin 30).
  addUnitBall(world, {-2, 1, 0}, {5, 0, 0});
  addUnitBall(world, {std::sqrt(3.0) / 2, 1, 0.5});
  return world;
}

World makeFrictionBallsSlip(std::size_t, std::uint64_t) {
  World world = roughWorld();
  // High enough that A, which friction throws down, stays in the air.
  addUnitBall(world, {-2, 6, 0}, {5, 0, 0}, {0, 0, 20});
  addUnitBall(world, {1, 6, 0});
  return world;
}

World makeBilliard(std::size_t, std::uint64_t) {
  World world = freeWorld();
  addUnitBall(world, {0, 1, 0}, {5, 0, 0});
  addUnitBall(world, {3, 1, 0.4});
  addUnitBall(world, {8, 1, 2.4});
  return world;
}

World makeCircleBilliard(std::size_t, std::uint64_t) {
  World world = freeWorld();
  world.arena.radius = 10;
  addUnitBall(world, {0, 1, 3}, {5, 0, 0});
  return world;
}

World makeCradle(std::size_t, std::uint64_t) {
  World world = freeWorld();
  addUnitBall(world, {-0.3, 1, 0}, {1, 0, 0});
  for (int k = 1; k < 5; ++k) addUnitBall(world, {k * 1.001, 1, 0});
  return world;
}

World makeGalperin(std::size_t, std::uint64_t) {
  World world = freeWorld();
  world.arena.radius = 10;
  addUnitBall(world, {8.5, 1, 0});
  addUnitBall(world, {6.5, 1, 0}, {2, 0, 0});
  world.balls.mass[1] = 1e4;
  return world;
}

World makeCollapse(std::size_t, std::uint64_t) {
  return threeInARow(0.05);
}

World makeCollapseTwin(std::size_t, std::uint64_t) {
  return threeInARow(0.08);
}

}  // namespace wells
