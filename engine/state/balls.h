// The balls of a world: a struct of arrays, all of the same length, indexed by ball id.
#pragma once

#include <cstddef>
#include <vector>

#include "math/ids.h"
#include "math/vector.h"

namespace wells {

/// What moves of one ball; what a hand-over carries.
struct BallState {
  Vec3 position = Vec3::Zero();  // m, of the centre
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();      // rad/s, angular velocity in the lab frame
};

inline bool isFinite(const BallState& ball) {
  return isFinite(ball.position) && isFinite(ball.velocity) && isFinite(ball.spin);
}

/// Solid spheres: the moment of inertia is kInertiaFactor * mass * radius^2 about every axis.
inline constexpr double kInertiaFactor = 2.0 / 5.0;

struct Balls {
  std::vector<Vec3> position;  // m, of the centre
  std::vector<Vec3> velocity;  // m/s
  std::vector<Vec3> spin;      // rad/s, angular velocity in the lab frame
  std::vector<double> radius;  // m, > 0
  std::vector<double> mass;    // kg, > 0

  std::size_t size() const { return position.size(); }

  void reserve(std::size_t count) {
    position.reserve(count);
    velocity.reserve(count);
    spin.reserve(count);
    radius.reserve(count);
    mass.reserve(count);
  }

  /// Appends a ball and returns its id.
  BallId add(const BallState& state, double ballRadius, double ballMass) {
    position.push_back(state.position);
    velocity.push_back(state.velocity);
    spin.push_back(state.spin);
    radius.push_back(ballRadius);
    mass.push_back(ballMass);
    return BallId{static_cast<std::uint32_t>(size() - 1)};
  }

  BallState state(std::size_t i) const { return {position[i], velocity[i], spin[i]}; }

  void setState(std::size_t i, const BallState& s) {
    position[i] = s.position;
    velocity[i] = s.velocity;
    spin[i] = s.spin;
  }
};

}  // namespace wells
