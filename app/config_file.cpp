#include "config_file.h"

#include <fmt/format.h>

#include <map>

#include "errors.h"
#include "keys.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

std::string withoutComment(std::string_view line) {
  return std::string(trimmed(line.substr(0, line.find("//"))));
}

std::string whereElse(const Setting& first) {
  return first.file.empty() ? "on the command line" : fmt::format("in line {}", first.line);
}

void requireOnce(const Key& key, const Setting& setting, const Setting& first) {
  if (key.repeat == Key::Repeat::Yes) return;
  throw UsageError(
      fmt::format("{}: {} is already given {} ({}); allowed: each key once, only Well "
                  "may be repeated",
                  describe(setting), setting.key, whereElse(first), describe(first)));
}

const Key& requireKey(const Setting& setting) {
  if (const Key* key = findKey(setting.key)) return *key;
  const std::string suggestion = suggestKey(setting.key);
  throw UsageError(
      fmt::format("{}: no such key: {}; {}allowed: the keys that \"gravity-wells keys\" "
                  "lists",
                  describe(setting), setting.key, suggestion.empty() ? "" : suggestion + " "));
}

}  // namespace

std::string describe(const Setting& setting) {
  if (setting.file.empty()) return fmt::format("--{} {}", setting.key, setting.value);
  return fmt::format("{}:{}: {}={}", setting.file.string(), setting.line, setting.key,
                     setting.value);
}

std::vector<Setting> readConfigFile(const std::filesystem::path& file) {
  std::vector<Setting> settings;
  int number = 0;
  for (const std::string& line : readLines(file)) {
    ++number;
    const std::string text = withoutComment(line);
    if (text.empty()) continue;
    const auto equals = text.find('=');
    const std::string key(trimmed(std::string_view(text).substr(0, equals)));
    if (equals == std::string::npos || key.empty()) {
      throw UsageError(fmt::format("{}:{}: \"{}\" is no setting; allowed: KEY=VALUE, // comment",
                                   file.string(), number, text));
    }
    const std::string value(trimmed(std::string_view(text).substr(equals + 1)));
    settings.push_back({.key = key, .value = value, .file = file, .line = number});
  }
  return settings;
}

std::vector<std::string> applySettings(Config& config, std::span<const Setting> settings) {
  std::map<std::string, Setting> seen;
  std::vector<std::string> unused;
  for (const Setting& setting : settings) {
    const Key& key = requireKey(setting);
    const auto [first, isNew] = seen.emplace(setting.key, setting);
    if (!isNew) requireOnce(key, setting, first->second);
    if (isNew && key.clear) key.clear(config);
    try {
      key.set(config, setting.value, setting.file.parent_path());
    } catch (const BadValue& bad) {
      throw UsageError(
          fmt::format("{}: {}; allowed: {}", describe(setting), bad.what(), key.allowed));
    }
    if (key.scope == Scope::Transport) unused.push_back(key.name);
  }
  if (unused.empty()) return {};
  return {fmt::format("{}: accepted, not used (peers find each other by multicast)",
                      joined(unused, ", "))};
}

}  // namespace wells
