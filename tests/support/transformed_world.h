// The same world seen from elsewhere: turned about the vertical, mirrored, moved with its arena,
// and with other ids. Physics does not notice.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "math/random.h"
#include "state/world.h"

namespace wells {

struct Transform {
  double cos = 1, sin = 0;          // of the turn about y
  double mirror = 1;                // -1: z is mirrored, before the turn
  Vec3 offset = Vec3::Zero();       // m
  std::vector<std::uint32_t> idOf;  // the new id, by old id

  Vec3 turned(const Vec3& p) const {
    const double z = mirror * p.z();
    return {cos * p.x() - sin * z, p.y(), sin * p.x() + cos * z};
  }

  Vec3 turnedBack(const Vec3& p) const {
    return {cos * p.x() + sin * p.z(), p.y(), mirror * (cos * p.z() - sin * p.x())};
  }

  World apply(const World& world) const {
    World result = world;
    result.arena.center = turned(world.arena.center) + offset;
    for (WellTrack& track : result.tracks)
      for (WellKeyframe& key : track.keyframes) key.position = turned(key.position) + offset;
    for (std::size_t i = 0; i < idOf.size(); ++i) {
      // Spin is an axial vector: a mirror turns it round.
      const BallState s = world.balls.state(i);
      result.balls.setState(
          idOf[i], {turned(s.position) + offset, turned(s.velocity), mirror * turned(s.spin)});
      result.balls.radius[idOf[i]] = world.balls.radius[i];
      result.balls.mass[idOf[i]] = world.balls.mass[i];
    }
    return result;
  }

  /// The balls of a transformed world, seen from the original one.
  Balls undo(const World& world) const {
    Balls result = world.balls;
    for (std::size_t i = 0; i < idOf.size(); ++i) {
      const BallState s = world.balls.state(idOf[i]);
      result.setState(i, {turnedBack(s.position - offset), turnedBack(s.velocity),
                          mirror * turnedBack(s.spin)});
      result.radius[i] = world.balls.radius[idOf[i]];
      result.mass[i] = world.balls.mass[idOf[i]];
    }
    return result;
  }
};

/// Random in everything; the offset is up to `farthest` (m) along each axis.
inline Transform randomTransform(std::uint64_t seed, std::size_t balls, double farthest) {
  Random random(seed);
  Transform t;
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  t.cos = std::cos(angle);
  t.sin = std::sin(angle);
  t.mirror = random.below(2) == 0 ? 1 : -1;
  for (int axis = 0; axis < 3; ++axis) t.offset[axis] = random.uniform(-farthest, farthest);
  for (std::uint32_t i = 0; i < balls; ++i) t.idOf.push_back(i);
  for (std::size_t i = balls; i > 1; --i) std::swap(t.idOf[i - 1], t.idOf[random.below(i)]);
  return t;
}

/// The same by quarter turns and without an offset, which rounds nothing.
inline Transform exactTransform(std::uint64_t seed, std::size_t balls) {
  Transform t = randomTransform(seed, balls, 0);
  constexpr double kCos[] = {1, 0, -1, 0};
  t.cos = kCos[seed % 4];
  t.sin = kCos[(seed + 3) % 4];
  return t;
}

}  // namespace wells
