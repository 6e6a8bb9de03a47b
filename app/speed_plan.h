// What the benchmark "speed" runs: scenes, each with a window of steps and a share of the time, and
// the methods that run them. Data; runs nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state/world.h"

namespace wells {

/// One way to simulate.
struct SpeedMethod {
  std::string engine = "ours";
  std::string contacts;         // of ours; empty: the scene's
  std::int64_t substeps = 0;    // of ours; 0: the scene's
  std::int64_t iterations = 0;  // likewise
  std::int64_t threads = 1;

  bool isBullet() const { return engine == "bullet"; }
  /// Exact contacts alone may take for ever on a heap.
  bool mayNotEnd() const { return contacts == "exact"; }
  friend bool operator==(const SpeedMethod&, const SpeedMethod&) = default;
};

/// "stock Bullet", "ours", "ours exact", "ours 4x1" (substeps x passes), "ours on 2 threads".
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
  std::int64_t steps;       // the window
  std::int64_t runs;        // within a process, because one is too short for the clock
  std::string_view column;  // of the row of "bench": the time that counts
  double share;             // s, in which further rounds may begin
};

/// All of them, from quick to slow.
std::span<const SpeedScene> speedScenes();
const SpeedScene& findSpeedScene(std::string_view name);

/// Stock Bullet first; then ours with each contact method, and by default with each further number
/// of threads.
std::vector<SpeedMethod> speedMethods(const SpeedScene& scene,
                                      std::span<const std::int64_t> threads);

/// Heaps: where the solver's settings matter. The first of them finds for each bound on the overlap
/// the cheapest of kTriedSettings; the larger ones use what it found.
bool isHeap(const SpeedScene& scene);
inline constexpr std::string_view kChoosingScene = "T1-10000";

struct OverlapBound {
  double ball;  // m, the worst of two balls, at the end
  std::string_view of;
};
inline constexpr OverlapBound kOverlapBounds[] = {{0.086, "Box3D"}, {0.049, "ODE"}};
inline constexpr double kArenaOverlapBound = 0.012;  // m, of ground and wall, in both

struct SolverSettings {
  std::int64_t substeps;
  std::int64_t iterations;
};
inline constexpr SolverSettings kTriedSettings[] = {{2, 2}, {2, 4}, {3, 2}, {3, 3}, {4, 1},
                                                    {4, 2}, {4, 3}, {6, 1}, {6, 2}, {8, 1}};

}  // namespace wells
