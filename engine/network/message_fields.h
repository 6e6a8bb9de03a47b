// The fields of messages as our own types, and back.
#pragma once

#include <gravity_wells/ball_state_t.hpp>
#include <gravity_wells/peer_header_t.hpp>

#include "ownership/version.h"
#include "state/balls.h"

namespace wells {

Generation generationOf(const gravity_wells::peer_header_t& header);

/// The version of a ball in a message: its owner and its step stand outside the ball.
Version versionOf(const gravity_wells::peer_header_t& header,
                  const gravity_wells::ball_state_t& ball, const Incarnation& owner,
                  std::int64_t step);

BallState stateOf(const gravity_wells::ball_state_t& ball);

gravity_wells::ball_state_t ballMessage(std::size_t ball, const Version& version,
                                        const BallState& state);

}  // namespace wells
