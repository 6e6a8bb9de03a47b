// Holds a loop to a target rate and knows its actual rate. One per loop: simulation, network,
// graphics.
#pragma once

#include <chrono>

namespace wells {

class StepTimer {
 public:
  using Clock = std::chrono::steady_clock;

  /// targetRate in Hz; 0 or less: no target, waitForNextTick returns at once.
  explicit StepTimer(double targetRate) { setTargetRate(targetRate); }

  void setTargetRate(double targetRate);
  double targetRate() const { return targetRate_; }

  /// Sleeps until the next tick is due. A loop that is late by more than kMaxLag drops the ticks it
  /// missed instead of chasing them.
  void waitForNextTick();

  /// When the next tick is due.
  Clock::time_point nextTick() const { return next_; }

  /// Ticks per second of wall time over the whole run, Hz; 0 before the second tick.
  double meanRate() const;

  /// Ticks per second over about the last second, Hz.
  double recentRate() const { return recentRate_; }

  /// Wall time since the first tick, s.
  double elapsed() const;

 private:
  static constexpr std::chrono::milliseconds kMaxLag{250};
  double targetRate_ = 0;
  Clock::duration interval_{};
  Clock::time_point next_{};
  Clock::time_point first_{};
  Clock::time_point last_{};
  Clock::time_point windowStart_{};
  long ticks_ = 0;
  long windowTicks_ = 0;
  double recentRate_ = 0;
};

}  // namespace wells
