// Draws a schedule from a seed.
#pragma once

#include "simulation/fault.h"

namespace wells::simulation {

struct SessionShape {
  int peers = 3;        // 2 .. 5
  int balls = 8;        // 1 .. 100
  double seconds = 66;  // simulated, >= 60; the last ones for the comparison of the views
};

Schedule drawSchedule(std::uint64_t seed, const SessionShape& shape);

}  // namespace wells::simulation
