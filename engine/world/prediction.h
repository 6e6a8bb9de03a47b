// Where a ball will be that nobody touches: what a peer shows of another peer's ball between two of
// its states. The same code as the owner's step, so that the prediction of a ball that can meet
// no other ball has the owner's bits, if no contact in substeps lasted at its start.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// The state at the start of step `to` of ball number `ball` that has `state` at the start of step
/// `from` and meets nothing but ground and wall. Uses world.tracks at those steps; world.step and
/// the other balls do not matter. to < from returns `state`. A ball that leans on others
/// (world.leaning) is not alone: it moves on at its velocity, as ghosts in a heap do in the step.
BallState predict(const World& world, std::size_t ball, const BallState& state, std::int64_t from,
                  std::int64_t to);

}  // namespace wells
