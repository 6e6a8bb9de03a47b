// A World as the oracles see it, and back.
#pragma once

#include <vector>

#include "state/world.h"
#include "support/event_driven.h"
#include "support/taylor_flight.h"

namespace wells::oracle {

inline P pointOf(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

inline Vec3 vectorOf(const P& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

inline std::vector<Body> bodiesOf(const World& world) {
  std::vector<Body> bodies;
  const Balls& b = world.balls;
  for (std::size_t i = 0; i < b.size(); ++i)
    bodies.push_back({pointOf(b.position[i]), pointOf(b.velocity[i]), pointOf(b.spin[i]),
                      b.radius[i], b.mass[i]});
  return bodies;
}

/// Gravity is vertical and the arena stands at the origin.
inline Rules rulesOf(const World& world) {
  return {-world.settings.gravity.y(), world.settings.elasticity, world.settings.friction,
          world.arena.radius};
}

/// For ball 0 of radius r between the world's wells, which are at rest, above the ground.
inline TaylorFlight flightOf(const World& world) {
  std::vector<SoftWell> wells;
  for (const WellTrack& track : world.tracks)
    wells.push_back(
        {pointOf(track.keyframes[0].position), track.keyframes[0].strength, track.softening});
  return {wells, -world.settings.gravity.y(), world.balls.radius[0], world.settings.elasticity};
}

}  // namespace wells::oracle
