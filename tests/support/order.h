// The observed order of a method: the slope of log(error) against log(step).
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace wells {

/// Least-squares slope over (step size, error) pairs; at least two, all positive.
inline double fittedOrder(const std::vector<std::pair<double, double>>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [step, error] : errors) {
    const double x = std::log(step);
    const double y = std::log(error);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const auto n = static_cast<double>(errors.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace wells
