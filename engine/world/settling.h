// When a world counts as settled: the one definition for measures, benchmarks and documentation.
// Not whether its balls are at rest to the bit: a heap that creeps may count as settled.
#pragma once

#include <algorithm>
#include <limits>

namespace wells {

inline constexpr double kSettledShare = 1e-3;  // of the highest kinetic energy so far
inline constexpr double kSettledTime = 2;      // s

/// A world is settled once its kinetic energy (translation and rotation, all balls) has been below
/// kSettledShare of its peak, or nothing, for kSettledTime. It is no longer when the energy rises
/// again.
class Settling {
 public:
  /// `time` in s, rising from call to call; `kineticEnergy` in J.
  void add(double time, double kineticEnergy) {
    time_ = time;
    peak_ = std::max(peak_, kineticEnergy);
    const bool isQuiet = kineticEnergy < kSettledShare * peak_ || kineticEnergy == 0;
    quietSince_ = isQuiet ? std::min(quietSince_, time) : kNever;
  }

  bool isSettled() const { return time_ - quietSince_ >= kSettledTime; }
  double peak() const { return peak_; }  // J

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double time_ = 0;
  double peak_ = 0;
  double quietSince_ = kNever;  // s
};

}  // namespace wells
