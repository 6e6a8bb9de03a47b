#include "speed_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wells {
namespace {

constexpr std::int64_t kFewestWeighed = 10000;  // balls
constexpr double kMiB = 1024 * 1024;            // bytes

/// Of a world's energy, in a step: what sums of so many numbers are rounded by.
constexpr double kRounding = 1e-12;

}  // namespace

PairedRatio timesBullet(const SpeedResult& result, const SpeedRow& row) {
  return pairedRatio(result.rows.front().times, row.times);
}

std::optional<PairedRatio> timesOneThread(const SpeedResult& result, const SpeedRow& row) {
  if (row.method.threads == 1) return {};
  SpeedMethod single = row.method;
  single.threads = 1;
  const auto found = std::ranges::find(result.rows, single, &SpeedRow::method);
  if (found == result.rows.end()) return {};
  return pairedRatio(found->times, row.times);
}

std::optional<double> ballBytes(const SpeedResult& result, const SpeedRow& row) {
  if (result.scene->balls < kFewestWeighed) return {};
  return row.row->number("memory_MiB") * kMiB / static_cast<double>(result.scene->balls);
}

double ballBound(const SpeedResult& result, const SpeedRow& row) {
  if (row.method.ballBound) return *row.method.ballBound;
  return result.rows.front().row->number("ball_overlap_m");
}

bool keepsBounds(const SpeedResult& result, const SpeedRow& row) {
  const BenchRow& r = *row.row;
  const double energy =
      std::max(std::abs(r.number("energy_start_J")), std::abs(r.number("energy_end_J")));
  return r.number("ball_overlap_m") <= ballBound(result, row) &&
         r.number("ground_overlap_m") <= kArenaBound && r.number("wall_overlap_m") <= kArenaBound &&
         r.number("escaped") == 0 &&
         r.number("contacts_J") <= kRounding * energy * static_cast<double>(result.steps);
}

SpeedRunner::SpeedRunner(const SpeedOptions& options,
                         std::function<void(const std::string&)> progress)
    : options_(options), progress_(std::move(progress)) {}

SpeedResult SpeedRunner::begin(const SpeedScene& scene) const {
  const std::int64_t steps = options_.steps > 0 ? options_.steps : scene.steps;
  SpeedResult result{&scene, steps, options_.repeats, {}};
  for (const SpeedMethod& method : speedMethods(scene, options_.threads))
    result.rows.push_back({method});
  return result;
}

double SpeedRunner::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double SpeedRunner::left() const {
  return options_.minutes * 60 - elapsed();
}

double SpeedRunner::planned(const SpeedResult& result) const {
  const SpeedScene& scene = *result.scene;
  return scene.roundTime * static_cast<double>(result.steps) / static_cast<double>(scene.steps);
}

bool SpeedRunner::hasTimeFor(const SpeedResult& result) const {
  if (result.rounds() > 0) return result.roundTime <= left();
  const double pace = plannedTime_ > 0 ? spentTime_ / plannedTime_ : 1;
  return pace * planned(result) <= left();
}

void SpeedRunner::addRound(SpeedResult& result) {
  const double start = elapsed();
  for (SpeedRow& row : result.rows) {
    progress_(fmt::format("{}, round {} of up to {}, {}; {:.0f} s, at most {:.0f} s left",
                          result.scene->name, row.times.size() + 1, options_.repeats,
                          name(row.method), elapsed(), std::max(0.0, left())));
    addToRound(result, row);
  }
  const double time = elapsed() - start;
  result.roundTime = std::max(result.roundTime, time);
  if (result.rounds() > 1) return;
  plannedTime_ += planned(result);
  spentTime_ += time;
}

void SpeedRunner::addToRound(const SpeedResult& result, SpeedRow& row) {
  const SpeedScene& scene = *result.scene;
  std::vector<std::string> words = arguments(row.method);
  words.insert(words.end(),
               {"--scene", std::string(scene.scene), "--balls", std::to_string(scene.balls),
                "--steps", std::to_string(result.steps), "--runs", std::to_string(scene.runs)});
  if (row.row) words.emplace_back("--no-books");
  BenchRow measured = runBenchChild(words, options_.out);
  row.times.push_back(measured.number(std::string(scene.column)));
  if (!row.row) row.row = std::move(measured);
}

}  // namespace wells
