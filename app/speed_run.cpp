#include "speed_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace wells {
namespace {

constexpr double kLongestTrial = 20;      // s, of a method that may never end
constexpr std::int64_t kWeighed = 10000;  // balls: fewer vanish in what a process takes anyway
constexpr double kMiB = 1024 * 1024;      // bytes

bool keeps(const BenchRow& row, double ballBound) {
  return row.number("ball_overlap_m") <= ballBound &&
         row.number("ground_overlap_m") <= kArenaOverlapBound &&
         row.number("wall_overlap_m") <= kArenaOverlapBound && row.number("escaped") == 0 &&
         row.number("contacts_J") <= 0;
}

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

double SpeedTimer::elapsed() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

double SpeedTimer::left() const {
  return minutes_ * 60 - elapsed();
}

double SpeedTimer::scaled(double share) const {
  return share * minutes_ / kFullMinutes;
}

SpeedRunner::SpeedRunner(const SpeedOptions& options,
                         std::function<void(const std::string&)> progress)
    : options_(options), progress_(std::move(progress)), timer_(options.minutes) {}

SpeedResult SpeedRunner::run(const SpeedScene& scene) {
  const double start = timer_.elapsed();
  SpeedResult result{&scene, stepsOf(scene), options_.repeats, {}};
  for (const SpeedMethod& method : speedMethods(scene, options_.threads))
    result.rows.push_back({method});
  if (isHeap(scene))
    for (const SpeedMethod& method : chosen())
      for (const std::int64_t threads : options_.threads) {
        SpeedMethod threaded = method;
        threaded.threads = threads;
        result.rows.push_back({threaded});
      }
  double longest = 0;  // s, of a round
  for (std::int64_t round = 0; round < options_.repeats; ++round) {
    const double roundStart = timer_.elapsed();
    const bool isLate = roundStart + longest > start + timer_.scaled(scene.share);
    if (round > 0 && (isLate || longest > timer_.left())) break;
    for (SpeedRow& row : result.rows) {
      progress_(fmt::format("{}, round {} of up to {}, {}; {:.0f} s, at most {:.0f} s left",
                            scene.name, round + 1, options_.repeats, name(row.method),
                            timer_.elapsed(), std::max(0.0, timer_.left())));
      addToRound(scene, row);
    }
    longest = std::max(longest, timer_.elapsed() - roundStart);
  }
  return result;
}

BenchRow SpeedRunner::runOnce(const SpeedScene& scene, const SpeedMethod& method, Books books,
                              double limit) {
  std::vector<std::string> words = arguments(method);
  words.insert(words.end(),
               {"--scene", std::string(scene.scene), "--balls", std::to_string(scene.balls),
                "--steps", std::to_string(stepsOf(scene)), "--runs", std::to_string(scene.runs)});
  if (books == Books::None) words.emplace_back("--no-books");
  return runBenchChild(words, options_.out, limit);
}

void SpeedRunner::addToRound(const SpeedScene& scene, SpeedRow& row) {
  if (!row.note.empty()) return;
  const SpeedMethod& method = row.method;
  const bool isFirst = !row.row;
  const Books books = isFirst && !method.isBullet() ? Books::Kept : Books::None;
  const auto once = [&] {
    BenchRow measured = runOnce(scene, method, books, method.mayNotEnd() ? kLongestTrial : 3600);
    row.times.push_back(measured.number(std::string(scene.column)));
    if (!isFirst) return;
    row.row = std::move(measured);
    findMemory(scene, row);
  };
  if (!method.mayNotEnd()) return once();
  try {
    once();
  } catch (const TooSlow&) {
    row.note = fmt::format("not done in {:.0f} s", kLongestTrial);
  } catch (const RunError&) {
    row.note = "gave up";
  }
}

const std::vector<SpeedMethod>& SpeedRunner::chosen() {
  if (!chosen_) chosen_ = choose();
  return *chosen_;
}

std::vector<SpeedMethod> SpeedRunner::choose() {
  const SpeedScene& scene = findSpeedScene(kChoosingScene);
  struct Trial {
    SpeedMethod method;
    BenchRow row;
  };
  std::vector<Trial> trials;
  for (const SolverSettings& settings : kTriedSettings) {
    SpeedMethod method;
    method.substeps = settings.substeps;
    method.iterations = settings.iterations;
    progress_(fmt::format("{}, which solver settings keep the bounds on overlap: {}; {:.0f} s",
                          scene.name, name(method), timer_.elapsed()));
    trials.push_back({method, runOnce(scene, method, Books::Kept, 3600)});
  }
  std::ranges::stable_sort(trials, {},
                           [](const Trial& trial) { return trial.row.number("ms_per_step"); });
  std::vector<SpeedMethod> chosen;
  for (const OverlapBound& bound : kOverlapBounds) {
    const auto found = std::ranges::find_if(
        trials, [&](const Trial& trial) { return keeps(trial.row, bound.ball); });
    if (found != trials.end() && std::ranges::find(chosen, found->method) == chosen.end())
      chosen.push_back(found->method);
  }
  return chosen;
}

double SpeedRunner::emptyProcess(const std::string& engine) {
  const std::vector<std::string> words = {"--engine", engine, "--scene",   "bounce",
                                          "--steps",  "1",    "--no-books"};
  return runBenchChild(words, options_.out).number("peak_rss_MiB");
}

void SpeedRunner::findMemory(const SpeedScene& scene, SpeedRow& row) {
  if (scene.balls < kWeighed) return;
  const double more = row.row->number("peak_rss_MiB") - emptyProcess(row.method.engine);
  row.ballBytes = more * kMiB / static_cast<double>(scene.balls);
}

}  // namespace wells
