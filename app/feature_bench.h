// The benchmark "features": what each feature costs a world that does not have it, has it and does
// not use it, or uses it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "paired_ratio.h"

namespace wells {

/// What a feature may cost that is there and not used.
inline constexpr double kMostUnused = 1.02;

struct FeatureRow {
  std::string_view feature;
  std::string_view scene;
  std::string_view unusedIs;
  double absent = 0;  // ms a step, median
  PairedRatio unused{};
  std::string_view busyScene;
  std::string_view usedIs;
  double busyAbsent = 0;  // ms a step, median
  PairedRatio used{};

  bool isFree() const { return unused.median <= kMostUnused; }
};

std::string featureText(std::span<const FeatureRow> rows);
std::string featureCsv(std::span<const FeatureRow> rows);

/// Parses and runs "bench features"; `arguments` without these words, argv as main got it. Throws
/// UsageError and RunError.
int runFeatureBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
