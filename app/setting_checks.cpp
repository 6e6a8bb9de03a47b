#include "setting_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "keys.h"
#include "values.h"

namespace wells {
namespace {

constexpr std::string_view kWellNames[] = {setting::kWell, setting::kWellPosition,
                                           setting::kWellStrength, setting::kWellPath};

std::string refusal(std::string_view key, std::string_view value, std::string_view allowed) {
  return fmt::format("{} is {}; it must be {}", key, value, allowed);
}

// As `configKey` of a peer's config takes it.
std::optional<std::string> checkAsConfig(std::string_view key, std::string_view value,
                                         std::string_view configKey) {
  const Key& known = *findKey(configKey);
  try {
    Config scratch;
    known.set(scratch, value, {});
    return std::nullopt;
  } catch (const BadValue&) {
    return refusal(key, value, known.allowed);
  }
}

std::optional<std::string> checkPath(std::string_view key, std::string_view value) {
  const Key& known = *findKey(setting::kWellPath);
  try {
    Config scratch;
    known.set(scratch, value, {});
    if (scratch.wellPath.kind != WellPath::Kind::Keyframes) return std::nullopt;
  } catch (const BadValue&) {
  }
  return refusal(key, value, allowedWellPath());
}

}  // namespace

std::optional<WellSetting> wellSetting(std::string_view key) {
  const auto dot = key.find('.');
  if (dot == std::string_view::npos || key.front() == '0') return std::nullopt;
  const std::string_view name = key.substr(dot + 1);
  if (std::ranges::find(kWellNames, name) == std::end(kWellNames)) return std::nullopt;
  const std::string_view number = key.substr(0, dot);
  if (number.empty() || !std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  try {
    return WellSetting{PeerId{static_cast<std::int32_t>(parseInteger(number, 1, kMaxPeerId))},
                       name};
  } catch (const BadValue&) {
    return std::nullopt;
  }
}

std::string allowedWellPath() {
  const std::string& allowed = findKey(setting::kWellPath)->allowed;
  return allowed.substr(0, allowed.find(", or the name of a"));
}

std::optional<std::string> checkPeerSetting(std::string_view key, std::string_view value) {
  if (key == setting::kNetworkRate) return checkAsConfig(key, value, key);
  const auto well = wellSetting(key);
  if (!well) return fmt::format("{}: no such setting", key);
  if (well->name == setting::kWell) {
    if (value == "attract" || value == "repel" || value == "off") return std::nullopt;
    return refusal(key, value, "attract, repel or off");
  }
  if (well->name == setting::kWellPath) return checkPath(key, value);
  return checkAsConfig(key, value, well->name);
}

}  // namespace wells
