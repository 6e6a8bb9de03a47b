#include "feature_bench.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "bench_row.h"
#include "command_line.h"
#include "engines.h"
#include "feature_list.h"
#include "progress.h"
#include "text_file.h"
#include "values.h"
#include "work_precision.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

constexpr int kWarmUp = 5;  // steps, in which memory is taken

struct FeatureOptions {
  std::vector<std::string> features;
  std::int64_t repeats = 11;
  std::int64_t steps = 100;
  fs::path out = "out/features";
};

std::optional<FeatureOptions> parse(std::span<const std::string> arguments) {
  std::vector<std::string> names;
  for (const Feature& feature : features()) names.emplace_back(feature.name);
  CLI::App app{
      fmt::format(
          "What each feature costs a step: a world without it beside one that has it but nothing "
          "that uses it, and beside one that uses it. A feature that is there and not used is free "
          "when it makes the median step at most {} times as long; so much noise is left on a "
          "quiet "
          "machine, and the feature \"nothing\" shows how much there is now. Writes features.csv "
          "and features.txt.",
          kMostUnused),
      "./run.sh bench features"};
  FeatureOptions options;
  addChoice(app, "--features", options.features, names, "default: all, " + joined(names, ", "));
  addInteger(app, "--repeats", options.repeats, 1, 1000, "rounds; medians count (default 11)");
  addInteger(app, "--steps", options.steps, 1, 10'000, "that are timed in a round (default 100)");
  addPath(app, "--out", options.out, "FOLDER", "for all files (default out/features)");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};
  return options;
}

/// CPU time (s) of this thread, the simulation's.
double threadTime() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// s, of a step.
double timeOfStep(const FeatureRun& run) {
  if (run.meanwhile) run.meanwhile();
  const double before = threadTime();
  run.step();
  return threadTime() - before;
}

struct PairedTimes {
  std::vector<double> absent;  // ms a step, by round
  std::vector<double> present;

  PairedRatio ratio() const { return pairedRatio(present, absent); }
};

/// Of two, now one first, now the other.
constexpr std::array<std::size_t, 2> inTurn(std::int64_t n) {
  return n % 2 == 0 ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 0};
}

/// Runs without and with the feature step in turn, so that both meet the machine in the same moods.
PairedTimes compare(const Feature& feature, const FeatureScene& scene, Presence presence,
                    const FeatureOptions& options) {
  const std::array presences = {Presence::Absent, presence};
  PairedTimes times;
  for (std::int64_t round = 0; round < options.repeats; ++round) {
    std::array<FeatureRun, 2> runs;
    std::array<double, 2> time{};  // ms a step
    // What is made first lies elsewhere in memory, what steps first finds other caches.
    for (const std::size_t i : inTurn(round))
      runs[i] = feature.make(scene.make(), presences[i], options.out);
    for (std::int64_t step = -kWarmUp; step < options.steps; ++step)
      for (const std::size_t i : inTurn(step)) {
        const double taken = timeOfStep(runs[i]);
        if (step >= 0) time[i] += 1e3 * taken / static_cast<double>(options.steps);
      }
    times.absent.push_back(time[0]);
    times.present.push_back(time[1]);
  }
  return times;
}

FeatureRow measureFeature(const Feature& feature, const FeatureOptions& options) {
  FeatureRow row{.feature = feature.name,
                 .unusedIs = feature.unused,
                 .scene = feature.scene.name,
                 .usedIs = feature.used,
                 .usedScene = feature.usedIn.name};
  if (!feature.unused.empty())
    row.unused = compare(feature, feature.scene, Presence::Unused, options).ratio();
  const PairedTimes used = compare(feature, feature.usedIn, Presence::Used, options);
  row.absent = median(used.absent);
  row.used = used.ratio();
  return row;
}

std::string range(const PairedRatio& ratio) {
  return fmt::format("{:.3f} ({:.3f}..{:.3f})", ratio.median, ratio.least, ratio.most);
}

std::string columns(const PairedRatio& ratio) {
  return fmt::format("{:.5g},{:.5g},{:.5g}", ratio.median, ratio.least, ratio.most);
}

std::string_view verdict(const FeatureRow& row) {
  if (!row.unused) return "";
  return row.isFree() ? "pass" : "FAIL";
}

}  // namespace

std::string featureText(std::span<const FeatureRow> rows) {
  std::string text = fmt::format("{:<18} {:<27} {:<18} {:>21} {:<5} {:<28} {:<18} {:>9} {:>22}\n",
                                 "feature", "there, not used", "in", "unused / absent", "", "used",
                                 "in", "ms absent", "used / absent");
  for (const FeatureRow& row : rows)
    text += fmt::format("{:<18} {:<27} {:<18} {:>21} {:<5} {:<28} {:<18} {:>9.4g} {:>22}\n",
                        row.feature, row.unused ? row.unusedIs : "-", row.unused ? row.scene : "-",
                        row.unused ? range(*row.unused) : "-", verdict(row), row.usedIs,
                        row.usedScene, row.absent, range(row.used));
  return text;
}

std::string featureCsv(std::span<const FeatureRow> rows) {
  std::string csv = fmt::format(
      "feature,unused_is,scene,unused_to_absent,unused_least,unused_most,verdict,used_is,"
      "used_scene,absent_ms,used_to_absent,used_least,used_most,{}\n",
      kBuildColumns);
  for (const FeatureRow& row : rows)
    csv += fmt::format("{},{},{},{},{},{},{},{:.6g},{},{}\n", csvField(row.feature),
                       csvField(row.unusedIs), csvField(row.scene),
                       row.unused ? columns(*row.unused) : ",,", verdict(row), csvField(row.usedIs),
                       csvField(row.usedScene), row.absent, columns(row.used), buildColumns());
  return csv;
}

int runFeatureBench(std::span<const std::string> arguments, char** argv) {
  const std::optional<FeatureOptions> options = parse(arguments);
  if (!options) return 0;
  becomeExecutableOf("ours", argv);
  makeFolder("--out", options->out);
  std::vector<FeatureRow> rows;
  {
    const StatusLine line;
    for (const Feature& feature : features()) {
      if (std::ranges::find(options->features, feature.name) == options->features.end()) continue;
      line.show(
          fmt::format("{}, {} of {}", feature.name, rows.size() + 1, options->features.size()));
      rows.push_back(measureFeature(feature, *options));
    }
  }
  fs::remove(options->out / "features.png");
  writeAtomically(options->out / "features.csv", featureCsv(rows));
  writeAtomically(options->out / "features.txt", featureText(rows));
  fmt::print("{}\nTables: {}\n", featureText(rows), options->out.string());
  return 0;
}

}  // namespace wells
