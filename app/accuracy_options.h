// Options of `gravity-wells bench accuracy`.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accuracy_run.h"

namespace wells {

struct AccuracyOptions {
  std::vector<std::string> cases;    // names; all by default
  std::vector<std::string> engines;  // names; all by default
  LadderLimits limits;
  bool isQuick = false;
  std::filesystem::path out = "out/accuracy";
  std::filesystem::path points;  // not empty: only the points of the one engine, as JSON, to here
  bool list = false;
};

/// Nothing when help was shown. Throws UsageError.
std::optional<AccuracyOptions> parseAccuracyOptions(std::span<const std::string> arguments);

/// The arguments that make another process run one case with one engine, and write its points.
std::vector<std::string> accuracyArguments(const AccuracyOptions& options, const std::string& scene,
                                           const std::string& engine,
                                           const std::filesystem::path& points);

}  // namespace wells
