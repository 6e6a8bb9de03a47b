#include "accuracy_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "command_line.h"
#include "engines.h"
#include "errors.h"
#include "values.h"

namespace wells {
namespace {

const Range kLongestRuns = Range::between(1e-3, 3600);  // s
constexpr int kQuickRungs = 10;
constexpr double kQuickLongestRun = 0.02;      // s
constexpr double kQuickShortestTiming = 5e-4;  // s

std::vector<std::string> allCases() {
  std::vector<std::string> names;
  for (const AccuracyCase& answer : accuracyCases()) names.emplace_back(answer.scene);
  return names;
}

/// Falling, each once.
std::vector<double> parseStepSizes(const std::string& text) {
  const Range allowed = Range::between(1e-6, 1);
  std::vector<double> sizes;
  parseOption("--dt", text,
              fmt::format("numbers {}, in s, with commas between them", allowed.text()), [&] {
                for (const std::string_view word : splitAtCommas(text))
                  sizes.push_back(parseNumber(trimmed(word), allowed));
              });
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

}  // namespace

std::optional<AccuracyOptions> parseAccuracyOptions(std::span<const std::string> arguments) {
  CLI::App app{
      "Error against CPU time: runs the cases whose answer is known for ever smaller steps with "
      "every engine and method.\n"
      "Writes a table (CSV), a gnuplot script and a plot (PNG) for each case and an overview of "
      "all. The whole takes less than ten minutes.",
      "./run.sh bench accuracy"};
  AccuracyOptions options;
  std::int64_t repeats = 0;
  double longestRun = 0;
  addChoice(app, "--cases", options.cases, allCases(), "default: all; --list explains them");
  addChoice(app, "--engines", options.engines, {engineNames().begin(), engineNames().end()},
            "default: all: " + joined(engineNames(), ", "));
  addPath(app, "--out", options.out, "FOLDER", "for all files (default out/accuracy)");
  addInteger(app, "--repeats", repeats, 1, 100, "of each timing; the median counts (default 3)");
  app.add_option_function<std::string>(
         "--dt",
         [&](const std::string& value) { options.limits.stepSizes = parseStepSizes(value); },
         "these step sizes instead of ever smaller ones, however long they take")
      ->type_name("s,...");
  app.add_option_function<std::string>(
         "--longest-run",
         [&](const std::string& value) {
           parseOption("--longest-run", value,
                       fmt::format("a number {}, in s", kLongestRuns.text()),
                       [&] { longestRun = parseNumber(value, kLongestRuns); });
         },
         "CPU time; smaller steps that would take longer are not run, and listed (default 0.15)")
      ->type_name("s");
  app.add_flag("--quick", options.isQuick, "a rough look: fewer and shorter runs, each timed once");
  app.add_flag("--list", options.list, "lists the cases and ends");
  addPath(app, "--points", options.points, "FILE", "")->group("");  // for processes of our own
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};

  if (options.isQuick)
    options.limits = {.stepSizes = options.limits.stepSizes,
                      .rungs = kQuickRungs,
                      .longestRun = kQuickLongestRun,
                      .shortestTiming = kQuickShortestTiming,
                      .repeats = 1};
  if (repeats > 0) options.limits.repeats = repeats;
  if (longestRun > 0) options.limits.longestRun = longestRun;
  return options;
}

std::vector<std::string> accuracyArguments(const AccuracyOptions& options, const std::string& scene,
                                           const std::string& engine,
                                           const std::filesystem::path& points) {
  std::vector<std::string> arguments = {"bench",         "accuracy",
                                        "--cases",       scene,
                                        "--engines",     engine,
                                        "--points",      points.string(),
                                        "--repeats",     std::to_string(options.limits.repeats),
                                        "--longest-run", formatNumber(options.limits.longestRun)};
  if (options.isQuick) arguments.push_back("--quick");
  if (!options.limits.stepSizes.empty()) {
    std::vector<std::string> sizes;
    for (const double dt : options.limits.stepSizes) sizes.push_back(formatNumber(dt));
    arguments.insert(arguments.end(), {"--dt", joined(sizes, ",")});
  }
  return arguments;
}

}  // namespace wells
