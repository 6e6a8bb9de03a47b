// Messages that nobody honest has sent. A session must refuse each of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/random.h"

namespace wells::simulation {

struct RawMessage {
  std::string channel;
  std::vector<std::byte> bytes;
};

/// Spoiled in one way: cut off, lengthened, with a wild count, a number that is not finite, an id
/// beyond the last, on another's channel, of an unknown sender that claims a great version, or
/// plain noise. `honest` is what was sent before.
RawMessage forge(const RawMessage& honest, std::size_t balls, Random& random);

}  // namespace wells::simulation
