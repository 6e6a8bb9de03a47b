// How a peer predicts another peer's ball between two of its states: by the engine in use, so that
// both see the same flight.
#pragma once

#include <string_view>

#include "network/session_options.h"

namespace wells {

/// For an engine of this executable.
Predictor makePredictor(std::string_view engine);

/// For an engine that has no prediction of its own: it steps a world that holds only the one ball.
Predictor makeOneBallPredictor(std::string_view engine);

}  // namespace wells
