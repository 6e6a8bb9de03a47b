#include "setting_list.h"

#include <fmt/format.h>

#include <sstream>
#include <string_view>

#include "keys.h"
#include "session_finder.h"
#include "settable_keys.h"
#include "setting_checks.h"

namespace wells {
namespace {

// What the world's config says of a key of its own; empty: it has no such key, or was not heard.
// The config's Gravity is a number, and a session's a word.
std::string configured(const WatchedSession& session, const std::string& name) {
  const Key* key = findKey(name);
  if (!session.canonical || !key || key->scope != Scope::World || name == setting::kGravity)
    return "";
  std::istringstream lines(*session.canonical);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(name + "=")) return line.substr(name.size() + 1);
  return key->defaultText();
}

std::string unsetText(const SettableKey& key, const WatchedSession& session) {
  const std::string value = configured(session, key.name);
  return fmt::format("  {} = {}{}\n", key.name, value.empty() ? "" : value + ", ", key.unset);
}

std::string registerText(std::string_view key, const Register& r, std::string_view since) {
  return fmt::format("  {} = {}, {} step {}, set by {}\n", key, r.value, since, r.fromStep,
                     r.setBy);
}

}  // namespace

std::string settingList(const WatchedSession& session, double now) {
  std::string inForce, coming;
  const auto add = [&](const std::string& key, const Register& r) {
    const Register* holds = session.settings.inForce(key, session.step);
    if (holds) inForce += registerText(key, *holds, "since");
    if (!holds || *holds != r) coming += registerText(key, r, "from");
  };
  const auto& registers = session.settings.registers();
  for (const SettableKey& key : settableKeys()) {
    if (key.isOfAWell()) continue;
    const auto known = registers.find(key.name);
    if (known != registers.end()) add(known->first, known->second);
    // Of a later version that is to come we may not have heard what it follows.
    const bool isUnset = known == registers.end() || known->second.version == 1;
    if (isUnset && !session.settings.inForce(key.name, session.step))
      inForce += unsetText(key, session);
  }
  for (const auto& [key, r] : registers)
    if (wellSetting(key)) add(key, r);
  return fmt::format("Session {}, step {}, active peers {}\nIn force:\n{}{}{}",
                     generationText(session.generation), session.step,
                     idsText(activeIds(session, now)), inForce, coming.empty() ? "" : "To come:\n",
                     coming);
}

}  // namespace wells
