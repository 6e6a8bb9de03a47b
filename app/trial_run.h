// One run of a trial: a world, a method, a step; where the balls are at a few times of it, and what
// it cost. Compares two of them.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "state/world.h"

namespace wells {

/// A world at the start of a trial, and what must be done to it before each step (nothing if empty:
/// well tracks that grow, say).
struct TrialStart {
  World world;
  std::function<void(World&)> beforeStep;
};

/// Makes the same world for any step dt (s), since keyframes are counted in steps.
using TrialWorld = std::function<TrialStart(double dt)>;

/// What is chosen besides dt.
struct TrialMethod {
  std::string integrator;
  ContactMethod contacts = ContactMethod::Auto;
  int substeps = 4;

  friend bool operator==(const TrialMethod&, const TrialMethod&) = default;
};

/// The times at which runs are compared: multiples of `interval`. All runs have whole steps in it.
struct TrialTimes {
  double interval = 0;  // s
  int count = 0;
};

/// Positions (m) by ball.
using Positions = std::vector<Vec3>;

struct TrialRun {
  std::vector<Positions> samples;  // at interval, 2 interval ...
  std::int64_t steps = 0;          // that were made
  double work = 0;                 // s, estimated (stepWork), of these
  bool usedSubsteps = false;       // some ball was moved by substeps
  ContactMethod contacts =
      ContactMethod::Auto;  // in use, where the integrator forbids what is asked
};

/// What stops a run early, so that it has fewer samples than it should.
struct TrialStop {
  double work = std::numeric_limits<double>::infinity();  // s; more than this
  std::function<bool(const Positions&, int)> goesOn;      // asked at each sample; empty: always
};

/// Runs `start` with `stepsPerInterval` steps in each interval of `times`. Horizontal positions are
/// first changed by `nudge` (m), from ball to ball in other directions. What the engine throws
/// passes through.
TrialRun runTrial(const TrialWorld& world, const TrialMethod& method, const TrialTimes& times,
                  std::int64_t stepsPerInterval, const TrialStop& stop, double nudge = 0);

/// The largest distance (m) of a ball between two samples; infinite where only one is finite.
double largestDistance(const Positions& a, const Positions& b);

}  // namespace wells
