// Chooses how to simulate a world: the cheapest integrator, contact method, substeps and dt with
// which no ball is further than an error from where it should be, by trial. Prints nothing.
//
// Where the balls should be is what runs of the integrator of the highest order converge to:
// halving its step, twice, must change no position by more than half of the error. The choice
// is then made from runs whose distance from the last of these, with that change added, is within
// the error at each sampled time. Costs are estimated from counts (step_work.h), so that the same
// world gets the same choice each time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trial_run.h"

namespace wells {

/// A method with the longest step found with which it is within the error, or with which it was
/// given up.
struct TriedMethod {
  TrialMethod method;
  double dt = 0;     // s
  double error = 0;  // m, largest distance from the reference, and the reference's own; if reached
  double work = 0;   // s, estimated, for the trial
  bool isReached = false;
};

struct Choice {
  TriedMethod best;
  double duration = 0;     // s, over which the error holds
  std::string whyShorter;  // than the goal's; empty if it is not
  TrialMethod referenceMethod;
  double referenceDt = 0;          // s
  double referenceChange = 0;      // m, by the last halving
  std::vector<TriedMethod> tried;  // one for each integrator and contact method; best included
  bool isComplete = true;          // false: the bound of the trial ended the search
};

/// `progress` is called with what is tried next. Throws Unreachable.
Choice chooseMethod(const TrialWorld& world, const TrialGoal& goal,
                    const std::function<void(const std::string&)>& progress);

}  // namespace wells
