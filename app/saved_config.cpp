#include "saved_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "errors.h"
#include "keys.h"
#include "values.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

bool isSaved(const Key& key) {
  constexpr std::array<std::string_view, 5> kOfTheWell = {"PeerID", "WellPosition", "WellStrength",
                                                          "WellSoftening", "WellPath"};
  return key.scope == Scope::World ||
         std::find(kOfTheWell.begin(), kOfTheWell.end(), key.name) != kOfTheWell.end();
}

fs::path fromRoot(const fs::path& file) {
  return file.empty() ? file : fs::absolute(file).lexically_normal();
}

std::vector<std::string> savedValues(const Key& key, Config config) {
  config.ballsFile = fromRoot(config.ballsFile);
  config.wellPath.file = fromRoot(config.wellPath.file);
  return key.get(config);
}

std::vector<std::string> savedValues(const Key& key, const Snapshot& snapshot) {
  std::vector<std::string> values;
  for (const auto& [name, value] : snapshot.config)
    if (name == key.name) values.push_back(value);
  return values;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> savedConfig(const Config& config) {
  std::vector<std::pair<std::string, std::string>> saved;
  for (const Key& key : keys()) {
    if (!isSaved(key)) continue;
    for (const std::string& value : savedValues(key, config)) saved.emplace_back(key.name, value);
  }
  return saved;
}

Config restoredConfig(const Snapshot& snapshot, const fs::path& file) {
  std::vector<Setting> settings;
  for (const auto& [name, value] : snapshot.config)
    settings.push_back({.key = name, .value = value, .file = file});
  Config config;
  applySettings(config, settings);
  return config;
}

void requireAsSaved(const Snapshot& snapshot, const Config& config,
                    std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    const Key* key = findKey(setting.key);
    if (!key || !isSaved(*key)) continue;
    const auto saved = savedValues(*key, snapshot);
    if (savedValues(*key, config) == saved) continue;
    throw UsageError(fmt::format(
        "{}: contradicts the snapshot; allowed with --restore: {}, or nothing", describe(setting),
        saved.empty() ? fmt::format("no {}", key->name) : joined(saved, " ")));
  }
}

}  // namespace wells
