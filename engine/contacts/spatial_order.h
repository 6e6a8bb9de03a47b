// An order of balls in which those that are near each other in space are near each other in memory,
// so that contacts find both in the cache, and most contacts are within short stretches of it.
#pragma once

#include <span>
#include <vector>

#include "state/balls.h"

namespace wells {

/// Sorts by square columns of space, and those along a Z-order curve (Morton, "A computer oriented
/// geodetic data base", IBM 1966). It depends on positions and ids alone.
class SpatialOrder {
 public:
  /// `ids` rise, one at least; their positions are finite.
  void sort(const Balls& balls, std::span<const std::uint32_t> ids);

  std::span<const std::uint32_t> ids() const { return sorted_; }

 private:
  std::vector<std::uint32_t> sorted_;
  std::vector<std::uint32_t> column_;  // by ball given
  std::vector<std::uint32_t> next_;    // by column
};

}  // namespace wells
