// What a benchmark does with worlds that have settled (world/settling.h): brings them there, and
// watches what still moves.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "state/stepper.h"

namespace wells {

/// A world that takes longer is given up.
inline constexpr double kLongestSettling = 600;  // s, of its own time

/// Steps `world` until it has settled, or until all its balls sleep. `progress` is called with the
/// number of steps done. Throw RunError when that takes longer than kLongestSettling.
void settle(Stepper& stepper, World& world, const std::function<void(std::int64_t)>& progress);
void fallAsleep(Stepper& stepper, World& world, const std::function<void(std::int64_t)>& progress);

/// What moves in a settled world: creep and jitter.
class RestWatch {
 public:
  explicit RestWatch(const World& settled);

  /// After each step. O(N).
  void add(const World& world);

  /// s, of the world, when it began to watch.
  double settledAt() const { return settledAt_; }

  /// m, the furthest that a ball ever was from where it was then.
  double moved() const { return moved_; }

  /// J, the most by which the kinetic energy rose above an earlier value; 0: it only fell.
  double kineticRise() const { return rise_; }

 private:
  double settledAt_;
  std::vector<Vec3> start_;
  double leastEnergy_;  // J
  double moved_ = 0;
  double rise_ = 0;
};

}  // namespace wells
