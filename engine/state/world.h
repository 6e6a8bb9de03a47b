// The whole world at the start of a step: data only.
#pragma once

#include <cstdint>
#include <vector>

#include "state/arena.h"
#include "state/balls.h"
#include "state/changed_balls.h"
#include "state/settings.h"
#include "state/wells.h"

namespace wells {

/// Who computes a ball. A ghost is another peer's ball: it is predicted between its owner's states
/// and takes part in contacts with owned balls. Ghosts that touch each other drift on.
enum class Role : std::uint8_t { Owned, Ghost };

struct World {
  Settings settings;
  Arena arena;
  std::vector<WellTrack> tracks;  // how the wells move
  Balls balls;
  std::vector<Role> roles;  // by ball; empty: all owned (alone)
  std::int64_t step = 0;    // steps done; time is step * dt

  // By ball: not 0 if other balls held it in the last step. Derived, and filled by our engine where
  // there are ghosts; empty: unknown.
  std::vector<std::uint8_t> leaning;

  // Filled by setState() and setRole(); the next step of our engine takes note and clears it.
  ChangedBalls changed;

  double time() const { return static_cast<double>(step) * settings.dt; }  // s
  bool owns(std::size_t ball) const { return roles.empty() || roles[ball] == Role::Owned; }

  /// How anybody but an engine changes a ball that may be asleep (world/sleep.h).
  void setState(std::size_t ball, const BallState& state) {
    balls.setState(ball, state);
    changed.add(ball);
  }
  void setRole(std::size_t ball, Role role) {
    roles[ball] = role;
    changed.add(ball);
  }
  /// All at once; as many as there are.
  void setBalls(const Balls& others) {
    balls = others;
    for (std::size_t i = 0; i < balls.size(); ++i) changed.add(i);
  }
};

}  // namespace wells
