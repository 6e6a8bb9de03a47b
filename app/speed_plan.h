// What the benchmark "speed" runs: scenes, each with a window of steps, and the methods that run
// them. Data; runs nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state/world.h"

namespace wells {

/// One way to simulate.
struct SpeedMethod {
  std::string_view engine = "ours";
  std::string_view contacts = {};    // of ours; empty: the scene's
  std::int64_t substeps = 0;         // of ours; 0: the scene's
  std::int64_t iterations = 0;       // likewise
  std::string_view integrator = {};  // likewise; empty: the scene's
  /// m, the overlap of two balls that the settings are there to keep; nothing: stock Bullet's.
  std::optional<double> ballBound = {};
  std::int64_t threads = 1;

  bool isBullet() const { return engine == "bullet"; }
  friend bool operator==(const SpeedMethod&, const SpeedMethod&) = default;
};

/// "stock Bullet", "ours", "ours exact", "ours 3x2 leapfrog" (substeps x passes), "ours on 2
/// threads".
std::string name(const SpeedMethod& method);

/// The options of "bench" that ask for it.
std::vector<std::string> arguments(const SpeedMethod& method);

/// The same for a world at hand; threads are the engine's.
void apply(const SpeedMethod& method, Settings& settings);

/// Engines are compared on the same world over the same steps, from the first one on.
struct SpeedScene {
  std::string_view name;   // what --scenes takes
  std::string_view scene;  // of the catalogue
  std::int64_t balls;
  std::int64_t steps;                  // the window
  std::int64_t runs;                   // within a process, because one is too short for the clock
  std::string_view column;             // of the row of "bench": the time that counts
  double roundTime;                    // s, about what a round takes on a quiet machine
  std::span<const SpeedMethod> tuned;  // cheap settings that keep a bound on overlap
};

/// All of them, from quick to slow.
std::span<const SpeedScene> speedScenes();
const SpeedScene& findSpeedScene(std::string_view name);

/// Stock Bullet first, then ours: the default, with each contact method where balls are not too
/// many, and the scene's tuned settings. What has other rows for threads has one for one thread.
std::vector<SpeedMethod> speedMethods(const SpeedScene& scene,
                                      std::span<const std::int64_t> threads);

}  // namespace wells
