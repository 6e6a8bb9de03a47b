#include "math/elementary.h"

#include <cmath>

namespace wells {
namespace {

constexpr double kLn2High = 0x1.62e42fee00000p-1;  // ln 2, upper 32 bits: k * kLn2High is exact
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

// Taylor series on |x| <= pi/4; the first neglected term is below 1e-18.
double sineNearZero(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 + sum) * (-s / (k * (k - 1)));
  return x * (1 + sum);
}

double cosineNearZero(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 18; k >= 2; k -= 2) sum = (1 + sum) * (-s / (k * (k - 1)));
  return 1 + sum;
}

}  // namespace

SinCos sinCosOfTurns(double turns) {
  // Reduction by quarter turns is exact in binary, which is why the argument is in turns.
  const double quarters = 4 * turns;
  const double nearest = std::nearbyint(quarters);
  const double x = (quarters - nearest) * (kPi / 2);
  const double s = sineNearZero(x);
  const double c = cosineNearZero(x);
  const double modulo = nearest - 4 * std::floor(nearest / 4);
  switch (static_cast<int>(modulo)) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double exponential(double x) {
  const double k = std::nearbyint(x / (kLn2High + kLn2Low));
  const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= 0.35
  double sum = 0;
  for (int i = 18; i >= 1; --i) sum = (1 + sum) * (r / i);
  return std::ldexp(1 + sum, static_cast<int>(k));
}

double naturalLogarithm(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // m in [1/2, 1)
  if (m < 0.70710678118654752440) {
    m *= 2;
    --exponent;
  }
  // ln m = 2 artanh z = 2 (z + z^3/3 + z^5/5 + ...), z = (m-1)/(m+1), |z| <= 0.1716
  const double z = (m - 1) / (m + 1);
  const double s = z * z;
  double sum = 0;
  for (int k = 25; k >= 1; k -= 2) sum = sum * s + 1.0 / k;
  return exponent * kLn2High + (2 * z * sum + exponent * kLn2Low);
}

}  // namespace wells
