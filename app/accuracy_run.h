// Runs one case of the accuracy suite with one method for ever smaller steps. Error and CPU time
// come from separate runs. Engines of this executable only.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "scenes/exact_answers.h"
#include "work_precision.h"

namespace wells {

/// What bounds a ladder.
struct LadderLimits {
  std::vector<double> stepSizes;   // s, falling; not empty: these alone, however long they take
  double coarsestStep = 2.0 / 15;  // s; with it 1/60 s is the fourth
  int rungs = 20;
  double longestRun = 0.15;      // s of CPU time; a step size that would take longer is not run
  double shortestTiming = 5e-3;  // s of CPU time; shorter runs are repeated until they fill it
  std::int64_t repeats = 3;      // of each timing
};

/// Runs of more steps keep no books, which take several times the time of the steps.
inline constexpr std::int64_t kMostBookedSteps = 50'000;

/// The method that the program uses when nothing else is said.
Method defaultMethod();

/// All methods of an engine: of ours each integrator with each contact method, and the default one.
std::vector<Method> methodsOf(std::string_view engine);

/// `progress` is called with the dt (s) that begins. Throws RunError when a run cannot be repeated
/// with the same bits, since then what was timed is not what was measured.
Ladder runLadder(const AccuracyCase& answer, const Method& method, const LadderLimits& limits,
                 const std::function<void(double)>& progress);

}  // namespace wells
