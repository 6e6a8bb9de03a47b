#include "settable_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "keys.h"
#include "network/codec.h"
#include "network/shared_settings.h"
#include "setting_checks.h"
#include "values.h"

namespace wells {
namespace {

constexpr const char* kAsConfigured = "as configured";

// What a key of the same name takes in a config file.
std::string configAllowed(std::string_view key) {
  return findKey(key)->allowed;
}

constexpr std::string_view kAnyPeer = "N.";

std::string wellKeyName(std::string_view name) {
  return fmt::format("{}{}", kAnyPeer, name);
}

std::vector<SettableKey> makeKeys() {
  using std::string;
  return {
      {string(setting::kPause), "true or false", "the world stands still, for all peers", "false"},
      {string(setting::kSimulationRate), "10 to 10000 Hz", "steps in a wall second", kAsConfigured},
      {string(setting::kNetworkRate), configAllowed(setting::kNetworkRate),
       "how often each peer sends what is due", kAsConfigured},
      {string(setting::kGravity), "on, off or reversed", "compared with the world's own", "on"},
      {string(setting::kElasticity), "0 to 1", "coefficient of restitution", kAsConfigured},
      {string(setting::kFriction), "0 to 100", "coefficient of friction", kAsConfigured},
      {string(setting::kRollingResistance), "0 to 1e6 m", "lever arm of rolling resistance",
       kAsConfigured},
      {string(setting::kReset), "now", "the world starts over; what was set stays", "never"},
      {wellKeyName(setting::kWell), "attract, repel or off",
       "what the well of peer N does, as strongly as it is", kAsConfigured},
      {wellKeyName(setting::kWellStrength), configAllowed(setting::kWellStrength),
       "strength of the well of peer N; > 0 attracts, < 0 repels", kAsConfigured},
      {wellKeyName(setting::kWellPosition), configAllowed(setting::kWellPosition),
       "place of the well of peer N", kAsConfigured},
      {wellKeyName(setting::kWellPath), allowedWellPath(),
       "how the well of peer N moves; as the config key", kAsConfigured}};
}

std::string listed() {
  std::vector<std::string> names;
  for (const SettableKey& key : settableKeys()) names.push_back(key.name);
  return joined(names, ", ");
}

// Of a well's key the name behind the number is compared.
std::string nearestSettable(std::string_view key) {
  const auto dot = key.find('.');
  const std::string name(key.substr(dot == std::string_view::npos ? 0 : dot + 1));
  std::vector<std::string> names;
  for (const SettableKey& known : settableKeys())
    names.push_back(known.isOfAWell() ? known.name.substr(kAnyPeer.size()) : known.name);
  const std::string nearest = nearestWord(name, names);
  const bool isOfAPeer = wellSetting("1." + nearest).has_value();
  if (nearest.empty() || !isOfAPeer) return nearest;
  const std::string number(key.substr(0, dot == std::string_view::npos ? 0 : dot));
  return fmt::format("{}.{}", wellSetting(number + ".Well") ? number : "N", nearest);
}

}  // namespace

std::span<const SettableKey> settableKeys() {
  static const std::vector<SettableKey> keys = makeKeys();
  return keys;
}

const SettableKey* findSettableKey(std::string_view key) {
  const auto well = wellSetting(key);
  const std::string name = well ? wellKeyName(well->name) : std::string(key);
  if (!well && name.starts_with(kAnyPeer)) return nullptr;
  const auto keys = settableKeys();
  const auto found = std::ranges::find(keys, name, &SettableKey::name);
  return found == keys.end() ? nullptr : &*found;
}

std::string settingFault(std::string_view key, std::string_view value) {
  if (!findSettableKey(key)) {
    const std::string nearest = nearestSettable(key);
    return fmt::format("{}: no such setting;{} allowed: {} (N: the number of a peer, 1 to {})", key,
                       nearest.empty() ? "" : fmt::format(" did you mean {}?", nearest), listed(),
                       kMaxPeerId);
  }
  if (key == setting::kReset)
    return value == "now" ? "" : fmt::format("{} is {}; it must be now", key, value);
  if (value.size() > kMaxSettingValue)
    return fmt::format("{} has {} characters; at most {} are allowed", key, value.size(),
                       kMaxSettingValue);
  if (!std::ranges::all_of(value, [](char c) { return c >= ' ' && c < 0x7f; }))
    return fmt::format("{}: the value has characters other than printable ASCII", key);
  const bool isOfThePeer = key == setting::kNetworkRate || wellSetting(key);
  const auto fault = isOfThePeer ? checkPeerSetting(key, value) : checkSessionSetting(key, value);
  return fault.value_or("");
}

std::string settableKeysText() {
  std::string text;
  for (const SettableKey& key : settableKeys())
    text += fmt::format("  {:<15} {}\n  {:15} {}\n", key.name, key.allowed, "", key.help);
  return text;
}

}  // namespace wells
