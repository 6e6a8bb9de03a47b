// A number that nobody else draws: for what has to be told apart on a network. Not for simulation.
#pragma once

#include <cstdint>
#include <random>

namespace wells {

/// Never 0, >= 0.
inline std::int64_t randomNumber() {
  std::random_device device;
  const std::uint64_t bits = (std::uint64_t{device()} << 32) | device();
  return static_cast<std::int64_t>(bits >> 1) | 1;
}

}  // namespace wells
