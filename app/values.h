// Text to value and back, for config keys, command-line options and CSV columns. Knows nothing of
// keys: the caller adds the place and the name to a BadValue.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "math/vector.h"

namespace wells {

/// A text that is no value of the wanted kind, or a value out of range. what() says why.
class BadValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The numbers that a value may take.
struct Range {
  enum class End { Open, Closed };
  double low = 0;
  End lowEnd = End::Closed;
  double high = 0;

  static Range between(double low, double high) { return {low, End::Closed, high}; }
  static Range above(double low, double high) { return {low, End::Open, high}; }

  bool contains(double x) const { return (lowEnd == End::Open ? x > low : x >= low) && x <= high; }
  /// "0 to 1", "above 0 to 1e6".
  std::string text() const;
};

std::string_view trimmed(std::string_view text);

/// A decimal number, optionally with the suffix f (40.f). Refuses what is not finite, subnormal
/// numbers, units and anything else after the number. Throws BadValue.
double parseNumber(std::string_view text);
double parseNumber(std::string_view text, const Range& range);

/// A whole number in decimal digits. Throws BadValue.
std::int64_t parseInteger(std::string_view text, std::int64_t low, std::int64_t high);

/// true/false, T/F, 1/0 in any case. Throws BadValue.
bool parseBoolean(std::string_view text);

/// Numbers separated by commas, one for each of `names` (used in messages). Throws BadValue.
std::vector<double> parseNumbers(std::string_view text, std::span<const std::string_view> names);

/// x,y,z. Throws BadValue.
Vec3 parseVector(std::string_view text);

/// The fewest digits that read back as the same number.
std::string formatNumber(double number);
std::string formatVector(const Vec3& v);

/// "a, b, c"
std::string joined(std::span<const std::string> words, std::string_view separator);

std::vector<std::string_view> splitAtCommas(std::string_view text);

/// The candidate that `word` was probably meant to be, or "" if none is near. Case counts little.
std::string nearestWord(std::string_view word, std::span<const std::string> candidates);

}  // namespace wells
