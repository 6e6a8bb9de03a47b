#include "scenes/accuracy.h"

namespace wells {
namespace {

constexpr double kRadius = 0.5;  // m
constexpr double kMass = 1;      // kg

void addBall(World& world, const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  world.balls.add({.position = position, .velocity = velocity}, kRadius, kMass);
}

/// Nothing but inertia and elastic, frictionless contacts.
World freeWorld() {
  World world;
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  return world;
}

}  // namespace

World makeElasticBounce(std::size_t, std::uint64_t) {
  World world;
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  addBall(world, {0, 5.5, 0});
  return world;
}

World makeSlideToRoll(std::size_t, std::uint64_t) {
  World world;
  world.settings.friction = 0.3;
  addBall(world, {0, 0.5, 0}, {5, 0, 0});
  return world;
}

World makeBilliard(std::size_t, std::uint64_t) {
  World world = freeWorld();
  addBall(world, {0, 1, 0}, {5, 0, 0});
  addBall(world, {3, 1, 0.4});
  addBall(world, {8, 1, 2.4});
  return world;
}

World makeCircleBilliard(std::size_t, std::uint64_t) {
  World world = freeWorld();
  world.arena.radius = 10;
  addBall(world, {0, 1, 3}, {5, 0, 0});
  return world;
}

World makeOrbit(std::size_t, std::uint64_t) {
  World world = freeWorld();
  world.tracks.push_back({.keyframes = {{0, Vec3{0, 20, 0}, 1000}}, .softening = 2});
  addBall(world, {10, 20, 0}, {0, 0, 6});
  return world;
}

}  // namespace wells
