// The zero of a function of one variable, by function values alone.
#pragma once

namespace wells {

/// The first sign change of f from > 0 at `low` to <= 0 at `high`: false position, kept safe by
/// bisection (Illinois: Dowell & Jarratt, BIT 11 (1971) 168). Returns the side where f <= 0.
template <class F>
double zeroOf(F f, double low, double atLow, double high, double atHigh) {
  double lowWeight = atLow;
  double highWeight = atHigh;
  for (int look = 0; look < 200; ++look) {
    double t = look % 4 == 3 ? low + (high - low) / 2
                             : low + (high - low) * (lowWeight / (lowWeight - highWeight));
    if (!(t > low && t < high)) t = low + (high - low) / 2;
    if (!(t > low && t < high)) break;
    const double value = f(t);
    if (value > 0) {
      low = t;
      lowWeight = value;
      highWeight /= 2;
    } else {
      high = t;
      highWeight = value;
      lowWeight /= 2;
      if (value == 0) break;
    }
  }
  return high;
}

}  // namespace wells
