#include "step_work.h"

#include <algorithm>

namespace wells {
namespace {

// s; see stepWork.
constexpr double kStep = 83e-9;
constexpr double kBall = 82e-9;
constexpr double kContact = 81e-9;  // that is possible: found, sorted, matched with the last step's
constexpr double kFreeEvaluation = 39e-9;   // of one well
constexpr double kExactBall = 160e-9;       // its paths and their meetings
constexpr double kExactEvaluation = 78e-9;  // of one well; an exact ball is looked at several times
constexpr double kImpact = 980e-9;          // with the meetings that it changes
constexpr double kSubstep = 25e-9;          // of one ball
constexpr double kSubstepEvaluation = 5.3e-9;  // of one well
constexpr double kIteration = 6.3e-9;          // of one contact

}  // namespace

double stepWork(const StepCounts& counts, const StepShape& shape) {
  const auto exact = static_cast<double>(counts.exactBalls);
  const auto inSubsteps = static_cast<double>(counts.substepBalls);
  const auto balls = static_cast<double>(shape.balls);
  const auto contacts = static_cast<double>(counts.contacts);
  const auto flights = static_cast<double>(counts.flightStretches);
  const auto evaluations = static_cast<double>(shape.evaluations) *
                           static_cast<double>(shape.wells);  // of one well, for a ball and flight
  const double touching = exact + inSubsteps;
  const double shareInSubsteps = touching > 0 ? inSubsteps / touching : 0;
  return kStep + kBall * balls + kContact * contacts +
         kFreeEvaluation * (balls - touching) * flights * evaluations +
         (kExactBall + kExactEvaluation * evaluations) * exact +
         kImpact * static_cast<double>(counts.impacts) + kSubstep * inSubsteps * shape.substeps +
         kSubstepEvaluation * inSubsteps * std::max<double>(shape.substeps, flights) * evaluations +
         kIteration * contacts * shareInSubsteps * shape.substeps * shape.iterations;
}

}  // namespace wells
