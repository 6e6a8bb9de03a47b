// What the small scenes are made of: balls of radius 0.5 m and 1 kg, and a world without forces.
#pragma once

#include "state/world.h"

namespace wells {

inline void addUnitBall(World& world, const Vec3& position, const Vec3& velocity = Vec3::Zero(),
                        const Vec3& spin = Vec3::Zero()) {
  world.balls.add({position, velocity, spin}, 0.5, 1);
}

/// Nothing but inertia and elastic, frictionless contacts.
inline World freeWorld() {
  World world;
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  return world;
}

}  // namespace wells
