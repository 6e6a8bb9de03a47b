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
  std::int64_t steps = 30;
  fs::path out = "out/features";
};

std::optional<FeatureOptions> parse(std::span<const std::string> arguments) {
  std::vector<std::string> names;
  for (const Feature& feature : features()) names.emplace_back(feature.name);
  CLI::App app{
      fmt::format(
          "What each feature costs a step: a world without it, with it but nothing that uses it, "
          "and with it in use, in turn. A feature that is there and not used is free when it makes "
          "the median step at most {} times as long; so much noise is left on a quiet machine. "
          "Writes features.csv and features.txt.",
          kMostUnused),
      "./run.sh bench features"};
  FeatureOptions options;
  addChoice(app, "--features", options.features, names, "default: all, " + joined(names, ", "));
  addInteger(app, "--repeats", options.repeats, 1, 1000, "rounds; medians count (default 11)");
  addInteger(app, "--steps", options.steps, 1, 10'000, "that are timed in a round (default 30)");
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

/// ms a step.
double timeOf(const FeatureRun& run, std::int64_t steps) {
  double time = 0;
  for (std::int64_t step = -kWarmUp; step < steps; ++step) {
    if (run.meanwhile) run.meanwhile();
    const double before = threadTime();
    run.step();
    if (step >= 0) time += threadTime() - before;
  }
  return 1e3 * time / static_cast<double>(steps);
}

FeatureRow measureFeature(const Feature& feature, const FeatureOptions& options) {
  const MakeFeatureRun busy = feature.makeBusy ? feature.makeBusy : feature.make;
  std::vector<double> absent, unused, busyAbsent, used;
  const auto time = [&](MakeFeatureRun make, Presence presence, std::vector<double>& times) {
    times.push_back(timeOf(make(presence, options.out), options.steps));
  };
  for (std::int64_t round = 0; round < options.repeats; ++round) {
    time(feature.make, Presence::Absent, absent);
    time(feature.make, Presence::Unused, unused);
    if (feature.makeBusy) time(busy, Presence::Absent, busyAbsent);
    time(busy, Presence::Used, used);
  }
  if (!feature.makeBusy) busyAbsent = absent;
  return {.feature = feature.name,
          .scene = feature.scene,
          .unusedIs = feature.unused,
          .absent = median(absent),
          .unused = pairedRatio(unused, absent),
          .busyScene = feature.makeBusy ? feature.busyScene : feature.scene,
          .usedIs = feature.used,
          .busyAbsent = median(busyAbsent),
          .used = pairedRatio(used, busyAbsent)};
}

std::string range(const PairedRatio& ratio) {
  return fmt::format("{:.3f} ({:.3f}..{:.3f})", ratio.median, ratio.least, ratio.most);
}

}  // namespace

std::string featureText(std::span<const FeatureRow> rows) {
  std::string text =
      fmt::format("{:<18} {:<18} {:>9}  {:<27} {:>21} {:<5} {:<28} {:>24}\n", "feature", "scene",
                  "ms absent", "there, not used", "unused / absent", "", "used", "used / absent");
  for (const FeatureRow& row : rows)
    text += fmt::format("{:<18} {:<18} {:>9.4g}  {:<27} {:>21} {:<5} {:<28} {:>24}\n", row.feature,
                        row.scene, row.absent, row.unusedIs, range(row.unused),
                        row.isFree() ? "pass" : "FAIL", row.usedIs, range(row.used));
  return text;
}

std::string featureCsv(std::span<const FeatureRow> rows) {
  std::string csv = fmt::format(
      "feature,scene,absent_ms,unused_is,unused_to_absent,unused_least,unused_most,verdict,"
      "busy_scene,busy_absent_ms,used_is,used_to_absent,used_least,used_most,{}\n",
      kBuildColumns);
  for (const FeatureRow& row : rows)
    csv += fmt::format(
        "{},{},{:.6g},{},{:.5g},{:.5g},{:.5g},{},{},{:.6g},{},{:.5g},{:.5g},{:.5g},{}\n",
        csvField(row.feature), csvField(row.scene), row.absent, csvField(row.unusedIs),
        row.unused.median, row.unused.least, row.unused.most, row.isFree() ? "pass" : "fail",
        csvField(row.busyScene), row.busyAbsent, csvField(row.usedIs), row.used.median,
        row.used.least, row.used.most, buildColumns());
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
