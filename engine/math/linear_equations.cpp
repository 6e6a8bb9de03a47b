#include "math/linear_equations.h"

#include <algorithm>
#include <cmath>

namespace wells {

bool solveLinear(std::span<double> matrix, std::span<double> b) {
  const std::size_t n = b.size();
  const auto row = [&](std::size_t i) { return matrix.data() + i * n; };
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(row(i)[k]) > std::abs(row(pivot)[k])) pivot = i;
    if (!(std::abs(row(pivot)[k]) > 0)) return false;
    if (pivot != k) {
      std::swap_ranges(row(k) + k, row(k) + n, row(pivot) + k);
      std::swap(b[k], b[pivot]);
    }
    const double* const upper = row(k);
    for (std::size_t i = k + 1; i < n; ++i) {
      double* const lower = row(i);
      const double factor = lower[k] / upper[k];
      if (factor == 0) continue;  // most are: a contact meets few others
      for (std::size_t j = k + 1; j < n; ++j) lower[j] -= factor * upper[j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= row(k)[j] * b[j];
    b[k] /= row(k)[k];
  }
  return std::all_of(b.begin(), b.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace wells
