#include "math/step_timer.h"

#include <thread>

namespace wells {
namespace {

double seconds(StepTimer::Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void StepTimer::setTargetRate(double targetRate) {
  targetRate_ = targetRate;
  interval_ = targetRate > 0 ? std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(1 / targetRate))
                             : Clock::duration::zero();
  next_ = Clock::now() + interval_;
}

void StepTimer::waitForNextTick() {
  if (targetRate_ > 0 && ticks_ > 0) {
    std::this_thread::sleep_until(next_);
    next_ += interval_;
    const auto now = Clock::now();
    if (now > next_ + kMaxLag) next_ = now + interval_;
  }
  last_ = Clock::now();
  if (ticks_ == 0) {
    first_ = windowStart_ = last_;
    next_ = last_ + interval_;
  }
  ++ticks_;
  ++windowTicks_;
  const double window = seconds(last_ - windowStart_);
  if (window >= 1) {
    recentRate_ = static_cast<double>(windowTicks_) / window;
    windowStart_ = last_;
    windowTicks_ = 0;
  }
}

double StepTimer::meanRate() const {
  const double span = seconds(last_ - first_);
  return span > 0 ? static_cast<double>(ticks_ - 1) / span : 0;
}

double StepTimer::elapsed() const {
  return ticks_ > 0 ? seconds(Clock::now() - first_) : 0;
}

}  // namespace wells
