#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

namespace wells {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

// from_chars takes no plus sign.
bool hasPlus(std::string_view text) {
  return text[0] == '+' && !text.starts_with("+-");
}

bool startsLikeUnit(std::string_view rest) {
  const auto c = static_cast<unsigned char>(rest.front());
  return std::isalpha(c) || c == '%' || c >= 0x80;
}

// Edits (insert, delete, replace) that turn a into b: Wagner & Fischer 1974, one row at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

// 1e6 rather than 1000000 or 1e+06.
std::string shortNumber(double number) {
  std::string text = fmt::format("{:g}", number);
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const int power = std::stoi(text.substr(exponent + 1));
  return fmt::format("{}e{}", text.substr(0, exponent), power);
}

}  // namespace

std::string Range::text() const {
  return fmt::format("{}{} to {}", lowEnd == End::Open ? "above " : "", shortNumber(low),
                     shortNumber(high));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

double parseNumber(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) throw BadValue("the value is missing");
  const char* const begin = text.data() + (hasPlus(text) ? 1 : 0);
  const char* const end = text.data() + text.size();
  double number = 0;
  const auto [rest, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range) throw BadValue("no double holds this number");
  if (error != std::errc{}) throw BadValue("not a number");
  if (!std::isfinite(number)) throw BadValue("not a finite number");
  if (std::fpclassify(number) == FP_SUBNORMAL) throw BadValue("a subnormal number");
  std::string_view after = trimmed({rest, static_cast<std::size_t>(end - rest)});
  if (after.empty() || after == "f" || after == "F") return number;
  if (startsLikeUnit(after)) {
    throw BadValue(
        fmt::format("\"{}\" after the number: a value carries no unit (only the suffix f)", after));
  }
  throw BadValue("not a number");
}

double parseNumber(std::string_view text, const Range& range) {
  const double number = parseNumber(text);
  if (!range.contains(number)) throw BadValue("out of range");
  return number;
}

std::int64_t parseInteger(std::string_view text, std::int64_t low, std::int64_t high) {
  text = trimmed(text);
  if (text.empty()) throw BadValue("the value is missing");
  const char* const begin = text.data() + (hasPlus(text) ? 1 : 0);
  const char* const end = text.data() + text.size();
  std::int64_t number = 0;
  const auto [rest, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range) throw BadValue("out of range");
  if (error != std::errc{} || rest != end) throw BadValue("not a whole number");
  if (number < low || number > high) throw BadValue("out of range");
  return number;
}

bool parseBoolean(std::string_view text) {
  const std::string word = lowered(trimmed(text));
  if (word == "true" || word == "t" || word == "1") return true;
  if (word == "false" || word == "f" || word == "0") return false;
  throw BadValue("neither true nor false");
}

std::vector<std::string_view> splitAtCommas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto comma = text.find(',');
    parts.push_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::vector<double> parseNumbers(std::string_view text, std::span<const std::string_view> names) {
  const auto parts = splitAtCommas(text);
  if (parts.size() != names.size()) {
    throw BadValue(fmt::format("{} number(s) instead of {}", parts.size(), names.size()));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    try {
      numbers.push_back(parseNumber(parts[i]));
    } catch (const BadValue& bad) {
      throw BadValue(fmt::format("{}={}: {}", names[i], parts[i], bad.what()));
    }
  }
  return numbers;
}

Vec3 parseVector(std::string_view text) {
  constexpr std::string_view kNames[] = {"x", "y", "z"};
  const auto n = parseNumbers(text, kNames);
  return {n[0], n[1], n[2]};
}

std::string formatNumber(double number) {
  return fmt::format("{}", number);
}

std::string formatVector(const Vec3& v) {
  return fmt::format("{},{},{}", v.x(), v.y(), v.z());
}

std::string joined(std::span<const std::string> words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words.begin(), words.end(), separator));
}

std::string nearestWord(std::string_view word, std::span<const std::string> candidates) {
  const std::string wanted = lowered(word);
  std::string best;
  std::size_t bestDistance = 2 + word.size() / 4;  // more edits than that is another word
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(wanted, lowered(candidate));
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace wells
