// Runs a scene of the benchmark "speed": all methods in turn, each in a process of its own, round
// after round for as long as the scene has time.
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
  std::vector<double> times = {};        // ms a step, by round
  std::optional<BenchRow> row = {};      // of the first round: physics is the same in all
  std::string note = {};                 // why there is no more
  std::optional<double> ballBytes = {};  // of memory, a ball
};

struct SpeedResult {
  const SpeedScene* scene;
  std::int64_t steps;
  std::int64_t wantedRounds;
  std::vector<SpeedRow> rows;  // stock Bullet first

  std::int64_t rounds() const { return static_cast<std::int64_t>(rows.front().times.size()); }
};

/// Bullet's time over that of `row`, round by round.
PairedRatio timesBullet(const SpeedResult& result, const SpeedRow& row);

/// The time with one thread over that of `row`, likewise. Nothing for rows of one thread.
std::optional<PairedRatio> timesOneThread(const SpeedResult& result, const SpeedRow& row);

/// How the whole goes on, and when it must end.
class SpeedTimer {
 public:
  /// `minutes` for a plan that takes kFullMinutes: shares shrink or grow with it.
  explicit SpeedTimer(double minutes) : minutes_(minutes) {}

  double elapsed() const;  // s
  double left() const;     // s
  /// s, of a scene's share.
  double scaled(double share) const;

 private:
  using Clock = std::chrono::steady_clock;
  double minutes_;
  Clock::time_point start_ = Clock::now();
};

inline constexpr double kFullMinutes = 12;

struct SpeedOptions {
  std::vector<std::string> scenes;
  std::vector<std::int64_t> threads = {1, 2};
  std::int64_t repeats = 5;
  std::int64_t steps = 0;  // 0: the scenes' windows
  double minutes = kFullMinutes;
  std::filesystem::path out = "out/speed";
};

class SpeedRunner {
 public:
  SpeedRunner(const SpeedOptions& options, std::function<void(const std::string&)> progress);

  /// All rounds of a scene. Throws RunError.
  SpeedResult run(const SpeedScene& scene);

  /// For each of kOverlapBounds the solver's settings that keep it soonest, as far as any of
  /// kTriedSettings does. The first call tries them all.
  const std::vector<SpeedMethod>& chosen();

  bool isOutOfTime() const { return timer_.left() <= 0; }

 private:
  enum class Books { Kept, None };

  std::int64_t stepsOf(const SpeedScene& scene) const {
    return options_.steps > 0 ? options_.steps : scene.steps;
  }
  BenchRow runOnce(const SpeedScene& scene, const SpeedMethod& method, Books books, double limit);
  std::vector<SpeedMethod> choose();
  void addToRound(const SpeedScene& scene, SpeedRow& row);
  /// MiB, of a process with one ball.
  double emptyProcess(const std::string& engine);
  void findMemory(const SpeedScene& scene, SpeedRow& row);

  const SpeedOptions& options_;
  std::function<void(const std::string&)> progress_;
  SpeedTimer timer_;
  std::optional<std::vector<SpeedMethod>> chosen_;
};

}  // namespace wells
