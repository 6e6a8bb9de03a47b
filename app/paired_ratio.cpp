#include "paired_ratio.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "work_precision.h"

namespace wells {

PairedRatio pairedRatio(std::span<const double> above, std::span<const double> below) {
  std::vector<double> ratios(std::min(above.size(), below.size()));
  for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] = above[i] / below[i];
  if (ratios.empty()) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const auto [least, most] = std::ranges::minmax(ratios);
  return {median(ratios), least, most};
}

}  // namespace wells
