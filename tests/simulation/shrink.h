// Makes a schedule that ends in a violation as short as it gets while it still ends in one of the
// same kind: drops faults (delta debugging: Zeller and Hildebrandt 2002, IEEE TSE 28, 183), then
// makes those that are left weaker, shorter and simpler.
#pragma once

#include "simulation/simulator.h"

namespace wells::simulation {

/// `failing` ends in a violation of `invariant`. At most `mostRuns` simulations are run.
Schedule shrink(const Schedule& failing, Invariant invariant, int mostRuns = 600);

}  // namespace wells::simulation
