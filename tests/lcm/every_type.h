// One message of every type of ours. Every field, in the order of its declaration, holds the next
// number of 1, 2, 3 ...; a string holds it in decimal, and a boolean is true when it is odd. Counts
// of arrays stand aside from that: they are what they count.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace wells {

/// By the name of the type, encoded.
using EncodedMessages = std::map<std::string, std::vector<std::uint8_t>>;

EncodedMessages encodeEveryType();

/// The channel that carries a type in these tests; in a session a type that is only a part of
/// others has none.
inline std::string channelOf(const std::string& type) {
  return "WELLS_TEST_" + type;
}

}  // namespace wells
