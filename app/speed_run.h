// Runs the scenes of the benchmark "speed" a round at a time: all methods in turn, each in a
// process of its own.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench_child.h"
#include "paired_ratio.h"
#include "speed_plan.h"

namespace wells {

/// What was measured with one method.
struct SpeedRow {
  SpeedMethod method;
  std::vector<double> times = {};    // ms a step, by round
  std::optional<BenchRow> row = {};  // of the first round: physics is the same in all
};

/// A scene and what was measured on it so far.
struct SpeedResult {
  const SpeedScene* scene;
  std::int64_t steps;
  std::int64_t wantedRounds;
  std::vector<SpeedRow> rows;  // stock Bullet first
  double roundTime = 0;        // s, the longest so far

  std::int64_t rounds() const { return static_cast<std::int64_t>(rows.front().times.size()); }
};

/// Bullet's time over that of `row`, round by round.
PairedRatio timesBullet(const SpeedResult& result, const SpeedRow& row);

/// The time with one thread over that of `row`, likewise. Nothing for rows of one thread.
std::optional<PairedRatio> timesOneThread(const SpeedResult& result, const SpeedRow& row);

/// Bytes a ball, of its memory column. Nothing for few balls, of which an engine's buffers hide how
/// much they take.
std::optional<double> ballBytes(const SpeedResult& result, const SpeedRow& row);

/// m, the overlap of two balls that `row` may not exceed.
double ballBound(const SpeedResult& result, const SpeedRow& row);
inline constexpr double kArenaBound = 0.012;  // m, of overlap with ground and wall

/// Whether `row`, of ours, keeps both bounds, lets nobody escape, and its contacts add no energy
/// beyond rounding.
bool keepsBounds(const SpeedResult& result, const SpeedRow& row);

struct SpeedOptions {
  std::vector<std::string> scenes;
  std::vector<std::int64_t> threads = {1, 2};
  std::int64_t repeats = 5;
  std::int64_t steps = 0;  // 0: the scenes' windows
  double minutes = 25;
  std::filesystem::path out = "out/speed";
};

class SpeedRunner {
 public:
  /// The time of `options` begins now.
  SpeedRunner(const SpeedOptions& options, std::function<void(const std::string&)> progress);

  /// Nothing measured yet.
  SpeedResult begin(const SpeedScene& scene) const;

  /// Whether a further round of it will be done in time.
  bool hasTimeFor(const SpeedResult& result) const;

  /// All methods once. Throws RunError.
  void addRound(SpeedResult& result);

 private:
  double elapsed() const;                           // s
  double left() const;                              // s
  double planned(const SpeedResult& result) const;  // s, of a round

  void addToRound(const SpeedResult& result, SpeedRow& row);

  const SpeedOptions& options_;
  std::function<void(const std::string&)> progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double plannedTime_ = 0;  // s, of the first rounds so far
  double spentTime_ = 0;    // s, what they took
};

}  // namespace wells
