// Which states to send next, when not all fit: first those whose prediction elsewhere has just gone
// wrong, then those that have waited longest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/world.h"

namespace wells {

/// How often states are due, s, and how many may go at once.
struct StatePace {
  double moving = 1.0 / 30;
  double resting = 1;
  std::size_t limit = 240;
};

class StateSchedule {
 public:
  explicit StateSchedule(std::size_t balls);

  /// Looks at what the last step did to the velocities.
  void observe(const World& world);

  /// Somebody needs the state of an owned ball: it is urgent, unless it was sent since `time` (s).
  void want(std::uint32_t ball, double time);

  /// All owned balls are urgent.
  void wantAll();

  /// The owned balls whose states are to be sent now, in rising order. They count as sent.
  std::vector<std::uint32_t> pick(const World& world, const StatePace& pace, double now);

 private:
  struct Ball {
    Vec3 velocity = Vec3::Zero();  // m/s, before the last step
    Vec3 change = Vec3::Zero();    // m/s, over the step before that
    double sent = -1e9;            // s
    bool isUrgent = false;         // it was jolted, or is newly ours
    bool wasOwned = false;
  };
  std::vector<Ball> balls_;
  std::vector<std::uint32_t> due_;  // scratch
};

}  // namespace wells
