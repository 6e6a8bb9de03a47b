#include "network/world_difference.h"

#include <map>

namespace wells {
namespace {

std::map<std::string_view, std::string_view> parse(std::string_view text) {
  std::map<std::string_view, std::string_view> values;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const auto equals = line.find('=');
    if (equals != line.npos) values[line.substr(0, equals)] = line.substr(equals + 1);
  }
  return values;
}

std::string sentence(std::string_view key, std::string_view theirs, std::string_view ours) {
  return std::string(key) + " is " + std::string(theirs) + " there and " + std::string(ours) +
         " here";
}

}  // namespace

std::string describeDifference(std::string_view theirs, std::string_view ours,
                               const DefaultValue& defaultOf) {
  const auto unset = [&](std::string_view key) {
    const std::string value = defaultOf ? defaultOf(key) : "";
    return value.empty() ? "not set" : value + " (the default)";
  };
  const auto there = parse(theirs);
  const auto here = parse(ours);
  for (const auto& [key, value] : here) {
    const auto other = there.find(key);
    if (other == there.end()) return sentence(key, unset(key), value);
    if (other->second != value) return sentence(key, other->second, value);
  }
  for (const auto& [key, value] : there)
    if (!here.contains(key)) return sentence(key, value, unset(key));
  return "all keys are equal, so the content of a file that they name differs";
}

}  // namespace wells
