// The colour of each peer, in balls, wells and legend alike.
#pragma once

#include <cstdint>

#include "render/image.h"

namespace wells {

/// The first eight peers have colours that people with deficient colour vision can tell apart too;
/// peers beyond get hues spread over the circle. 0 or less is nobody: grey.
Color peerColor(std::int32_t peer);

}  // namespace wells
