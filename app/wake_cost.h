// What a settled layer costs when some of it wakes: balls thrown in among others that sleep.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "state/stepper.h"

namespace wells {

struct WakeRow {
  std::int64_t thrown = 0;  // balls, 0: all sleep
  std::int64_t steps = 0;
  double awake = 0;     // balls, mean
  double stepTime = 0;  // s, mean
};

/// Throws none, 1, 10, 100 ... balls of `asleep`, in which all sleep and from which `stepper` has
/// just come, and runs a second of each. Throws RunError where the engine cannot start over.
std::vector<WakeRow> wakeCost(Stepper& stepper, const World& asleep);

std::string wakeText(std::span<const WakeRow> rows);
std::string wakeCsv(std::span<const WakeRow> rows);

}  // namespace wells
