// Records and who they speak of, for logs.
#pragma once

#include <string>

#include "ownership/records.h"

namespace wells::simulation {

/// "2#1a2b": the peer and the first digits of its incarnation's number.
std::string describe(const Incarnation& who);

/// "generation 0-4f11": its resets and the first digits of its nonce.
std::string describe(const Generation& generation);

/// "generation 0-4f11, term 1 by 2#1a2b, epoch 3, owner 1#77f0, step 120".
std::string describe(const Version& version);

/// The version, and whether its owner was heard.
std::string describe(const Record& record);

}  // namespace wells::simulation
