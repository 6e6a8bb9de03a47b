// Our engine: one step of the world on Bullet's candidate pairs.
#pragma once

#include <memory>

#include "state/stepper.h"

namespace wells {

/// A stepper named "ours". It keeps what makes the next step cheaper (the broadphase's boxes, the
/// impulses to start from) and may be handed a changed world at any time.
std::unique_ptr<Stepper> makeSimulation();

}  // namespace wells
