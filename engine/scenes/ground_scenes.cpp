#include "scenes/ground_scenes.h"

#include "math/elementary.h"
#include "scenes/unit_balls.h"

namespace wells {
namespace {

World dropped(double elasticity) {
  World world;
  world.settings.elasticity = elasticity;
  world.settings.friction = 0;
  addUnitBall(world, {0, 5.5, 0});
  return world;
}

World sliding(double backspin) {
  World world;
  world.settings.friction = 0.3;
  addUnitBall(world, {0, 0.5, 0}, {5, 0, 0}, {0, 0, backspin});
  return world;
}

World underWell(double distance) {
  World world;
  world.settings.friction = 0.3;
  world.tracks.push_back({.keyframes = {{0, {0, 0.5, 0}, 8}}, .softening = 2});
  addUnitBall(world, {distance, 0.5, 0});
  return world;
}

}  // namespace

World makeElasticBounce(std::size_t, std::uint64_t) {
  return dropped(1);
}

World makeZeno(std::size_t, std::uint64_t) {
  return dropped(0.8);
}

World makeZenoRest(std::size_t, std::uint64_t) {
  return dropped(0.5);
}

World makeSlideToRoll(std::size_t, std::uint64_t) {
  return sliding(0);
}

World makeBackspin(std::size_t, std::uint64_t) {
  return sliding(20);
}

World makeBackspinReturn(std::size_t, std::uint64_t) {
  return sliding(40);
}

World makeRollingUnderWell(std::size_t, std::uint64_t) {
  return underWell(0.1);
}

World makeRollingStops(std::size_t, std::uint64_t) {
  World world = sliding(0);
  world.settings.rollingResistance = 0.1;
  return world;
}

World makeStuckUnderWell(std::size_t, std::uint64_t) {
  World world = underWell(1);
  world.settings.rollingResistance = 0.01;
  return world;
}

World makeObliqueGround(std::size_t, std::uint64_t) {
  World world = freeWorld();
  world.settings.elasticity = 0.8;
  world.settings.friction = 0.3;
  for (const auto& [degrees, z] : {std::pair{60.0, -4.0}, {65.0, 4.0}}) {
    const SinCos angle = sinCosOfTurns(degrees / 360);
    addUnitBall(world, {0, 1, z}, {5 * angle.sin, -5 * angle.cos, 0});
  }
  return world;
}

}  // namespace wells
