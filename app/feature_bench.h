// The benchmark "features": what each feature costs a world that does not have it, has it and does
// not use it, or uses it.
#pragma once

#include <optional>
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
  std::string_view unusedIs;
  std::string_view scene;
  std::optional<PairedRatio> unused = {};  // over absent; nothing: it cannot be there unused
  std::string_view usedIs;
  std::string_view usedScene;
  double absent = 0;   // ms a step there, median
  PairedRatio used{};  // over absent

  bool isFree() const { return unused && unused->median <= kMostUnused; }
};

std::string featureText(std::span<const FeatureRow> rows);
std::string featureCsv(std::span<const FeatureRow> rows);

/// Parses and runs "bench features"; `arguments` without these words, argv as main got it. Throws
/// UsageError and RunError.
int runFeatureBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
