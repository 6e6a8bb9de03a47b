// Ratios of times that were measured in turn: what slows the machine down for a while slows down
// both of a pair, so pairs are divided before anything is averaged.
#pragma once

#include <span>

namespace wells {

struct PairedRatio {
  double median;
  double least;
  double most;
};

/// Of above[i] / below[i]. Of two lists the longer one's rest has no pair and does not count; of no
/// pair at all NaN.
PairedRatio pairedRatio(std::span<const double> above, std::span<const double> below);

}  // namespace wells
