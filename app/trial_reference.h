// Where the balls of a world should be: what runs of the integrator of the highest order converge
// to. It is known as far as halving the steps moves no ball by more than half of the error, twice
// in a row, or once by a sixteenth of that; a method of order p >= 1 is then off by no more than
// the last halving moved it.
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
  TriedMethod known;       // the cheapest of its runs, but for the last, that is within the error
  std::string whyShorter;  // than the goal's duration; empty if it is not
};

/// For a trial of `duration` (s) at most, with half of what is left to spend. Throws Unreachable.
Reference findReference(Trials& trials, const TrialGoal& goal, double duration);

}  // namespace wells
