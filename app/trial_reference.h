// Where the balls of a world should be: what runs of the integrator of the highest order converge
// to when its steps are halved, as far as they do.
#pragma once

#include <string>
#include <vector>

#include "trial_run.h"

namespace wells {

struct Reference {
  TrialTimes times;
  std::int64_t fewestSteps = 1;    // in an interval, that steps may be chosen
  std::vector<Positions> samples;  // at these times
  TrialMethod method;
  double dt = 0;           // s
  double change = 0;       // m, largest by the last halving; at most half of the error
  double coarserDt = 0;    // s, before the last halving: within the error, therefore
  double coarserWork = 0;  // s, estimated, of that run
  std::string whyShorter;  // than the goal's duration; empty if it is not
};

/// For a trial of `duration` (s) at most, with half of what is left to spend. Throws Unreachable.
Reference findReference(Trials& trials, const TrialGoal& goal, double duration);

}  // namespace wells
