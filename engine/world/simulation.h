// Our engine: one step of the world on Bullet's candidate pairs.
#pragma once

#include <cstddef>
#include <memory>

#include "state/stepper.h"

namespace wells {

/// With so many balls awake a step uses several threads. What fewer take is less than what waking
/// threads costs.
inline constexpr std::size_t kLeastBallsForThreads = 2000;

struct SimulationOptions {
  int threads = 1;  // a step's, 1 .. kMostThreads; the world has the same bits for any number
  std::size_t leastBallsForThreads = kLeastBallsForThreads;
};

/// A stepper named "ours". It keeps what makes the next step cheaper (the broadphase's boxes, the
/// impulses to start from) and may be handed a changed world at any time.
std::unique_ptr<Stepper> makeSimulation(const SimulationOptions& options = {});

}  // namespace wells
