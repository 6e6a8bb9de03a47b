// Runs a stress case with an engine and judges what it did by the promises of stress_cases.h, the
// same way for all engines.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scenes/stress_cases.h"
#include "state/stepper.h"

namespace wells {

/// The most energy that may appear, in parts of the energy at hand: EnergyPromise::NeverRises and
/// ::Pressed. One yardstick for all engines, whether they keep books or not; the first is what
/// rounding may do in single precision.
inline constexpr double kRoundingGain = 1e-6;
inline constexpr double kPressedGain = 1e-2;

/// A ball counts as lost when its centre is further outside than this part of its radius.
inline constexpr double kOutside = 1e-3;

/// Over all versions of a case: sums of counts, the worst of what must be small.
struct StressResult {
  std::int64_t steps = 0;
  double stepTime = 0;         // s, wall time of the steps alone
  std::int64_t lost = 0;       // balls whose centre is outside of the arena, most at once
  std::int64_t notFinite = 0;  // balls, most at once; those that start so are not counted
  double gain = 0;             // J, by which energy was ever above what it had been before
  double relativeGain = 0;     // to the larger of energy, kinetic energy and 1 J at the time
  double overlap = 0;          // m, from the step on by which the start's must be gone
  StepCounts counts;           // sums
  bool isInfected = false;     // a ball that starts not finite changed others
  bool isNamed = true;         // quarantined() was always the balls that start not finite
  bool isOutOfTime = false;
  std::string firstBroken;          // the first version in which a promise did not hold
  std::vector<std::string> gaveUp;  // what steps threw: version and reason
};

using MakeStepper = std::function<std::unique_ptr<Stepper>()>;

/// Called at each start and after each step: tests look at more than the result holds.
using StressObserver = std::function<void(const Stepper&, const World&)>;

/// Runs all versions, each with a new stepper and with `change` applied to its start. Ends after
/// the first step behind `mostTime` (s of wall time).
StressResult runStress(const StressCase& stress, const MakeStepper& makeStepper, double mostTime,
                       const std::function<void(World&)>& change = {},
                       const StressObserver& observe = {});

/// "held", or what did not hold: "gave up", "out of time", "not finite", "lost balls", "gained
/// energy", "infected".
std::string verdict(const StressCase& stress, const StressResult& result);

}  // namespace wells
