// The clocks that a session is driven by.
#pragma once

#include "network/session_options.h"

namespace wells {

/// Of this machine, now.
Times readClocks();

}  // namespace wells
