// Chooses how to simulate a world: the cheapest integrator, contact method, substeps and dt with
// which no ball is further than an error from where it should be, by trial. Prints nothing.
//
// Where the balls should be is what runs of the integrator of the highest order converge to
// (trial_reference.h). The choice is made from runs whose distance from that, with what it may
// itself be off by added, is within the error at each sampled time. Costs are estimated from counts
// (step_work.h), so that the same world gets the same choice each time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trial_run.h"

namespace wells {

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
