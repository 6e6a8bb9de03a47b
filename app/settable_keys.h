// The keys that ./run.sh set takes, for people: what each means and what it may be. What peers
// check is in network/shared_settings.h and setting_checks.h.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wells {

struct SettableKey {
  std::string name;     // of a peer's well: "N.WellStrength"
  std::string allowed;  // "10 to 10000 Hz"
  std::string help;
  std::string unset;  // what holds while nobody has set it

  bool isOfAWell() const { return name.starts_with("N."); }
};

/// In the order of help and lists.
std::span<const SettableKey> settableKeys();

/// nullptr: no such key. "2.WellStrength" is found as "N.WellStrength".
const SettableKey* findSettableKey(std::string_view key);

/// What is wrong with setting `key` to `value`, with what is allowed and, for a wrong key, the
/// nearest one; empty when nothing is.
std::string settingFault(std::string_view key, std::string_view value);

/// All keys, a line or two each, indented.
std::string settableKeysText();

}  // namespace wells
