#include "scenes/piles.h"

#include <cmath>

#include "scenes/unit_balls.h"

namespace wells {

World makeTetrahedralPile(double friction) {
  World world;
  world.settings.elasticity = 0;
  world.settings.friction = friction;
  const double side = 1 + kPileGap;
  const double fromAxis = side / std::sqrt(3.0);
  addUnitBall(world, {fromAxis, 0.5, 0});
  addUnitBall(world, {-fromAxis / 2, 0.5, side / 2});
  addUnitBall(world, {-fromAxis / 2, 0.5, -side / 2});
  addUnitBall(world, {0, 0.5 + std::sqrt(1 - fromAxis * fromAxis), 0});
  return world;
}

World makeStandingPile(std::size_t, std::uint64_t) {
  return makeTetrahedralPile(0.32);
}

World makeSlippingPile(std::size_t, std::uint64_t) {
  return makeTetrahedralPile(0.30);
}

World makeColumn(std::size_t balls, std::uint64_t) {
  World world;
  world.settings.elasticity = 0;
  for (std::size_t k = 0; k < balls; ++k) addUnitBall(world, {0, 0.5 + static_cast<double>(k), 0});
  return world;
}

World makeHeavyOnLight(std::size_t, std::uint64_t) {
  World world;
  addUnitBall(world, {0, 0.5, 0});
  addUnitBall(world, {0, 1.5, 0});
  world.balls.mass[1] = 1e6;
  return world;
}

World makeNudgedHeavyOnLight(std::size_t balls, std::uint64_t seed) {
  World world = makeHeavyOnLight(balls, seed);
  world.balls.position[1].x() += kNudge;
  return world;
}

}  // namespace wells
