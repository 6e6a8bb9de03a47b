// The ranges of every number that comes in by a message. Wide enough for any world that makes
// sense, narrow enough that nothing that a peer computes from them can overflow.
#pragma once

#include "network/codec.h"

namespace wells {

bool isInRange(const gravity_wells::heartbeat_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::wells_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::ball_states_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::offers_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::world_config_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::statistics_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::settings_t& message, const DecodeLimits& limits);
bool isInRange(const gravity_wells::request_t& message, const DecodeLimits& limits);

}  // namespace wells
