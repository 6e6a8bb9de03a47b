// What a step costs, estimated from what it did: the same number in each run and on each machine,
// so that what is chosen by it is, too. Measures no time.
#pragma once

#include <cstdint>

#include "state/stepper.h"

namespace wells {

/// What the counts of a step don't say.
struct StepShape {
  std::size_t balls = 0;
  std::size_t wells = 0;         // those that act
  std::int64_t evaluations = 0;  // of the field by the integrator, for one ball and flight
  int substeps = 1;
  int iterations = 1;
};

/// Estimated CPU time (s) of a step of ours. A sum over counts, fitted to measured times of runs of
/// 14 worlds (1 to 1000 balls, free flight to heaps) with all methods, each at four steps, on an
/// AMD EPYC: half of the 700 runs take 0.7 to 1.15 times the time measured, nine in ten 0.45
/// to 1.95 times; runs of one world differ less. Good for comparing methods, not for promising
/// times.
double stepWork(const StepCounts& counts, const StepShape& shape);

}  // namespace wells
