// Text in and out of a Transport, for tests.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "network/transport.h"

namespace wells {

/// Channel and content, in order of arrival.
using Received = std::vector<std::pair<std::string, std::string>>;

/// Holds only as long as `text` does; a temporary lives to the end of the full expression.
inline std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

inline std::string textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline Received drain(Transport& transport) {
  Received received;
  transport.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
    received.emplace_back(channel, textOf(bytes));
  });
  return received;
}

}  // namespace wells
