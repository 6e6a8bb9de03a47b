#include "scenes/wall_scenes.h"

#include "scenes/unit_balls.h"

namespace wells {
namespace {

World alongTheWall(double friction) {
  World world = freeWorld();
  world.arena.radius = 10;
  world.settings.friction = friction;
  addUnitBall(world, {9.5, 1, 0}, {0, 0, -5});
  return world;
}

World inTheCorner(const Vec3& spin) {
  World world;
  world.arena.radius = 10;
  world.settings.friction = 0.3;
  addUnitBall(world, {9.5, 0.5, 0}, {0, 0, -5}, spin);
  return world;
}

}  // namespace

World makeWhisperingGallery(std::size_t, std::uint64_t) {
  return alongTheWall(0);
}

World makeWallSlideToRoll(std::size_t, std::uint64_t) {
  return alongTheWall(0.3);
}

World makeWallRolling(std::size_t, std::uint64_t) {
  World world;
  world.arena.radius = 10;
  world.settings.friction = 0.3;
  addUnitBall(world, {9.5, 5, 0}, {0, 0, -38}, {0, -76, 0});
  return world;
}

World makeCornerSlideToRoll(std::size_t, std::uint64_t) {
  return inTheCorner({-10, 0, 0});
}

World makeCornerRolling(std::size_t, std::uint64_t) {
  World world = inTheCorner({-10, -10, 0});
  world.settings.drag = 0.9;
  return world;
}

}  // namespace wells
