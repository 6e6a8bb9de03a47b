// Runs the real session code of a few peers in one thread, on a network in memory, with simulated
// clocks and the faults of a schedule, and checks the promises after everything that happens. The
// same schedule gives the same run, to the bit.
#pragma once

#include <string>
#include <vector>

#include "simulation/fault.h"
#include "simulation/invariants.h"
#include "simulation/tally.h"
#include "simulation/trace.h"

namespace wells::simulation {

/// A run with fewer has shown little about hand-overs.
inline constexpr std::int64_t kFewHandovers = 100;

struct Outcome {
  std::vector<Violation> violations;
  Tally tally;
  std::string trace;  // the event log; empty unless it was asked for
};

/// Ends at the first violation.
Outcome simulate(const Schedule& schedule, Trace::Keeping keeping = Trace::Keeping::Nothing);

}  // namespace wells::simulation
