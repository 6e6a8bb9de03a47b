// What a world may have or do without, for the benchmark "features": each feature as runs without
// it, with it but nothing that uses it, and with it in use.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

#include "state/world.h"

namespace wells {

enum class Presence : std::uint8_t { Absent, Unused, Used };

/// A world and what runs it. It starts where every other run of its feature does.
struct FeatureRun {
  std::function<void()> step = {};       // one step; what is timed
  std::function<void()> meanwhile = {};  // what others do in that time, before it
};

struct FeatureScene {
  std::string_view name;
  World (*make)();
};

/// Of `start`, a scene's world. `folder` takes what a run writes.
using MakeFeatureRun = FeatureRun (*)(World start, Presence presence,
                                      const std::filesystem::path& folder);

struct Feature {
  std::string_view name;
  MakeFeatureRun make;
  std::string_view unused;     // how it is there and not used; empty: then it is absent
  const FeatureScene& scene;   // where that is compared
  std::string_view used;       // how it is used
  const FeatureScene& usedIn;  // where
};

std::span<const Feature> features();

}  // namespace wells
