// The physics of the simulated sessions: balls that swing through the middle and are knocked into
// another direction now and then, in a few floating-point operations a step. What matters of real
// physics here: everybody predicts a ball that nothing touches with the owner's bits, and nobody
// but the owner knows the knocks.
#pragma once

#include "network/session_options.h"
#include "state/world.h"

namespace wells::simulation {

inline constexpr double kStepRate = 20;  // Hz

/// `balls` in places and at speeds of their own.
World toyWorld(int balls);

/// Everything moves on by a step; the balls that `peer` owns are knocked when their time has come.
void toyStep(World& world, PeerId peer);

/// As Predictor: no knocks.
BallState toyPredict(const World& world, std::size_t ball, const BallState& state,
                     std::int64_t from, std::int64_t to);

/// All wells circle, each at its own place on the circle, so that each ball is soon nearest to
/// another one.
OwnWell toyWell();

}  // namespace wells::simulation
