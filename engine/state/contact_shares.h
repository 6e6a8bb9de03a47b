// What an engine's steps did, summed over a run: for reports and benchmarks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/stepper.h"

namespace wells {

/// Which contact method moved the balls.
struct ContactShares {
  std::int64_t ballSteps = 0;     // balls times steps
  std::int64_t exactBalls = 0;    // of those: by exact impacts, rolling and sliding
  std::int64_t substepBalls = 0;  // by substeps
  std::int64_t asleepBalls = 0;   // asleep at the end of the step; the others touched nothing
  std::int64_t impacts = 0;
  std::int64_t clusters = 0;
  std::int64_t handedOver = 0;       // islands that began as exact and were left to the substeps
  std::int64_t directContacts = 0;   // of substeps, solved directly; once for each substep
  std::int64_t unsolvedIslands = 0;  // small ones that the direct solver left to the passes

  void add(const StepCounts& step, std::size_t balls);
  double exact() const;    // 0 .. 1
  double substep() const;  // 0 .. 1
  double asleep() const;   // 0 .. 1
};

}  // namespace wells
