// What a world may have or do without, for the benchmark "features": each feature as three runs,
// without it, with it but nothing that uses it, and with it in use.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace wells {

enum class Presence : std::uint8_t { Absent, Unused, Used };

/// A world and what runs it. It starts where every other run of its feature does.
struct FeatureRun {
  std::function<void()> step;            // one step; what is timed
  std::function<void()> meanwhile = {};  // what others do in that time, before it
};

/// `folder` takes what a run writes.
using MakeFeatureRun = FeatureRun (*)(Presence presence, const std::filesystem::path& folder);

struct Feature {
  std::string_view name;
  std::string_view scene;
  std::string_view unused;  // how it is there and not used
  MakeFeatureRun make;
  std::string_view used;
  MakeFeatureRun makeBusy = nullptr;  // where in that scene nothing can use it: another one
  std::string_view busyScene = {};
};

std::span<const Feature> features();

}  // namespace wells
