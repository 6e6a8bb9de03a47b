// CPU time of the steps of a run, and of nothing else: no building of worlds, no first allocations.
#pragma once

#include <cstdint>

#include "accuracy_task.h"

namespace wells {

/// CPU time (s) of this process, all threads.
double cpuTime();

class StepTiming {
 public:
  /// Prepares and warms up. Runs shorter than `shortest` (s) are repeated until they fill it;
  /// `expected` (s) is about how long one takes. All must end with `stateHash`.
  StepTiming(const AccuracyTask& task, double shortest, double expected, std::uint64_t stateHash);

  /// CPU time (s) of the steps of one run. Throws RunError when a run ends with other bits, since
  /// then what is timed is not what was measured.
  double measure();

 private:
  struct Part {
    double time = 0;         // s
    std::int64_t steps = 0;  // in that time
  };
  /// How many runs to time at once.
  std::size_t together(double most) const;
  Part timeWarm();
  Part timeNew() const;
  void requireSameBits(const World& world) const;

  AccuracyTask task_;
  double shortest_;
  double expected_;
  std::uint64_t stateHash_;
  std::unique_ptr<Stepper> stepper_;
  StepperMemory start_;
};

}  // namespace wells
