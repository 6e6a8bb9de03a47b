// Reads config files and applies settings, from a file or from the command line, to a Config.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "config.h"

namespace wells {

/// A key and its value as the user wrote them, and where.
struct Setting {
  std::string key;
  std::string value;
  std::filesystem::path file{};  // empty: the command line
  int line = 0;                  // of the file, from 1
};

/// "config/template.txt:5: Elasticity=1.5" or "--Elasticity 1.5".
std::string describe(const Setting& setting);

/// The KEY=VALUE lines of a file. // starts a comment, also behind a value; blank lines don't
/// count. Throws UsageError when the file cannot be read or a line is no KEY=VALUE.
std::vector<Setting> readConfigFile(const std::filesystem::path& file);

/// Applies settings in order; returns notices for the user (one a line). Throws UsageError with
/// place, key, value and what is allowed, for an unknown key, a bad value, or a key given twice
/// (only Well may be: the wells of one call replace those of an earlier one).
std::vector<std::string> applySettings(Config& config, std::span<const Setting> settings);

}  // namespace wells
