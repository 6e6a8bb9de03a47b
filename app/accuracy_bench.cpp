#include "accuracy_bench.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "accuracy_files.h"
#include "accuracy_options.h"
#include "accuracy_run.h"
#include "child_process.h"
#include "engines.h"
#include "errors.h"
#include "ladder_json.h"
#include "plots.h"
#include "progress.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kLongestWait = 3600;  // s, for the points of one engine on one case

/// Says what runs, and how long the rest will take if it is like what has been done.
class Progress {
 public:
  explicit Progress(const AccuracyOptions& options) {
    for (const std::string& engine : options.engines)
      all_ += options.cases.size() * methodsOf(engine).size();
  }

  void begin(std::string_view scene, const Method& method) {
    what_ = fmt::format("{}, {}", scene, name(method));
    show("");
  }
  void showStep(double dt) const { show(fmt::format(", dt = {:.3g} s", dt)); }
  void end() { ++done_; }

 private:
  void show(const std::string& detail) const {
    const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
    const auto left = static_cast<double>(all_ - done_);
    line_.show(fmt::format(
        "{}{}; {} of {} lines done{}", what_, detail, done_, all_,
        done_ > 0 ? fmt::format(", {:.0f} s left", passed / static_cast<double>(done_) * left)
                  : ""));
  }

  StatusLine line_;
  Clock::time_point start_ = Clock::now();
  std::size_t all_ = 0;
  std::size_t done_ = 0;
  std::string what_;
};

std::string wholeFile(const fs::path& file) {
  std::string text;
  for (const std::string& line : readLines(file)) text += line + '\n';
  return text;
}

/// An engine of the other executable, in a process of its own.
Ladder runElsewhere(const AccuracyOptions& options, const std::string& scene,
                    const std::string& engine) {
  const fs::path points = options.out / fmt::format(".{}.json", engine);
  const fs::path log = options.out / fmt::format(".{}.log", engine);
  ChildProcess process(accuracyArguments(options, scene, engine, points), log);
  const std::optional<int> status = process.wait(kLongestWait);
  if (!status)
    throw RunError(fmt::format("{} on {}: not done after {} s", engine, scene, kLongestWait));
  if (*status != 0)
    throw RunError(fmt::format("{} on {}: ended with status {}; it said:\n{}", engine, scene,
                               *status, wholeFile(log)));
  const std::vector<Ladder> ladders = laddersFromJson(wholeFile(points));
  fs::remove(points);
  fs::remove(log);
  return ladders.at(0);
}

CaseResult runCase(const AccuracyOptions& options, const AccuracyCase& answer, Progress& progress) {
  CaseResult result{
      std::string(answer.scene), std::string(answer.about), answer.duration, answer.error, {}};
  for (const std::string& engine : options.engines)
    for (const Method& method : methodsOf(engine)) {
      progress.begin(answer.scene, method);
      result.ladders.push_back(
          hasEngine(engine)
              ? runLadder(answer, method, options.limits, [&](double dt) { progress.showStep(dt); })
              : runElsewhere(options, result.scene, engine));
      progress.end();
    }
  return result;
}

/// What a process of our own was started for.
int writePoints(const AccuracyOptions& options, char** argv) {
  const std::string& engine = options.engines.front();
  becomeExecutableOf(engine, argv);
  std::vector<Ladder> ladders;
  for (const Method& method : methodsOf(engine))
    ladders.push_back(
        runLadder(findAccuracyCase(options.cases.front()), method, options.limits, [](double) {}));
  writeAtomically(options.points, laddersAsJson(ladders));
  return 0;
}

void listCases() {
  for (const AccuracyCase& answer : accuracyCases())
    fmt::print("{:22} {:>5} s  {:>3}  {}\n", answer.scene, answer.duration, unitOf(answer.error),
               answer.about);
}

std::vector<CaseResult> runAll(const AccuracyOptions& options) {
  Progress progress(options);
  std::vector<CaseResult> results;
  for (const std::string& scene : options.cases) {
    results.push_back(runCase(options, findAccuracyCase(scene), progress));
    // At once: a run that is ended early leaves what it has.
    writeAtomically(options.out / (scene + ".csv"), pointsCsv(results.back()));
  }
  return results;
}

}  // namespace

int runAccuracyBench(std::span<const std::string> arguments, char** argv) {
  const auto options = parseAccuracyOptions(arguments);
  if (!options) return 0;
  if (options->list) {
    listCases();
    return 0;
  }
  if (!options->points.empty()) return writePoints(*options, argv);

  becomeExecutableOf("ours", argv);  // the one that starts the other
  makeFolder("--out", options->out);
  const std::vector<CaseResult> results = runAll(*options);
  const std::vector<CaseReach> reaches = compare(results);
  const std::string command =
      "./run.sh bench accuracy " + joined({arguments.data(), arguments.size()}, " ");
  writeAtomically(options->out / "overview.csv", overviewCsv(reaches));
  writeAtomically(options->out / "overview.txt", overviewText(reaches));
  writeAtomically(options->out / "conditions.txt", conditionsText(results, command));
  fmt::print("{}", overviewText(reaches));
  writePlotScripts(options->out, results);
  drawPlots(options->out, results);
  fmt::print("\nTables and plots: {}\n", options->out.string());
  return 0;
}

}  // namespace wells
