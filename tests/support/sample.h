// Repeated measurements of one thing: their mean and its standard error; and whether values follow
// a distribution.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace wells {

struct Sample {
  std::vector<double> values;

  double mean() const {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
  }

  /// Of the mean; needs two values.
  double standardError() const {
    const double center = mean();
    double squares = 0;
    for (const double v : values) squares += (v - center) * (v - center);
    const auto n = static_cast<double>(values.size());
    return std::sqrt(squares / (n - 1) / n);
  }

  /// The largest distance of the values' distribution from `below`, the wanted share of values
  /// below one, times the root of their number. Kolmogorov & Smirnov: above 1.358 in 5 % of all
  /// samples of that distribution.
  template <class Below>
  double kolmogorovSmirnov(Below below) const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const auto n = static_cast<double>(sorted.size());
    double worst = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const double wanted = below(sorted[i]);
      worst = std::max(
          {worst, wanted - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - wanted});
    }
    return worst * std::sqrt(n);
  }
};

inline constexpr double kKolmogorovSmirnov = 1.358;  // at 5 %

}  // namespace wells
