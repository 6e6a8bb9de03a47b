// Simulates many seeds on several threads. What comes out depends on the seeds only.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "simulation/draw_schedule.h"
#include "simulation/simulator.h"

namespace wells::simulation {

struct Failure {
  std::uint64_t seed = 0;
  Violation violation;  // the first of its run
};

struct SeedsOutcome {
  Tally tally;
  std::vector<Failure> failures;            // by rising seed
  std::vector<std::uint64_t> fewHandovers;  // seeds of such runs, rising
};

/// `progress` is told the number of seeds that are done, from any thread but never from two at
/// once; it may be empty.
SeedsOutcome runSeeds(std::uint64_t first, std::int64_t count, const SessionShape& shape, int jobs,
                      const std::function<void(const Tally&, std::size_t failures)>& progress);

}  // namespace wells::simulation
