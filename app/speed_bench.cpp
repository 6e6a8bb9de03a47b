#include "speed_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "bench_row.h"
#include "bench_settling.h"
#include "command_line.h"
#include "engines.h"
#include "gnuplot.h"
#include "progress.h"
#include "scenes/catalogue.h"
#include "speed_run.h"
#include "speed_table.h"
#include "stage_times.h"
#include "text_file.h"
#include "threads/thread_pool.h"
#include "values.h"
#include "wake_cost.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSleepingScene = "T3-10000";

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SpeedScene& scene : speedScenes()) names.emplace_back(scene.name);
  return names;
}

/// A rough look, at what was not asked for otherwise.
void beQuick(const CLI::App& app, SpeedOptions& options) {
  if (app.count("--scenes") == 0) options.scenes = {"T1-25", "T1-1000", "T2-10000"};
  if (app.count("--repeats") == 0) options.repeats = 2;
  if (app.count("--steps") == 0) options.steps = 60;
}

std::optional<SpeedOptions> parse(std::span<const std::string> arguments) {
  CLI::App app{
      "Ours (each contact method, and each number of threads) beside stock Bullet, in turn, each "
      "run in a process of its own: time of a step, ratio of each round, and what the physics "
      "did.\n"
      "\"Bullet / it\" is the median of the rounds' ratios with the least and the greatest; ours "
      "AxB has A substeps of B solver passes, fewer than by default. Beside each row of ours is "
      "written what overlap of two balls it may leave, and whether it does.\n"
      "Then the stages of a step of ours, and what balls cost that wake in a settled layer.\n"
      "Writes speed, stages and waking (CSV), speed.txt, and a gnuplot script and plot (PNG).",
      "./run.sh bench speed"};
  SpeedOptions options;
  bool isQuick = false;
  addChoice(app, "--scenes", options.scenes, sceneNames(),
            "default: all, " + joined(sceneNames(), ", "));
  addInteger(app, "--repeats", options.repeats, 1, 100,
             "rounds of a scene, if there is time; medians count (default 5)");
  addInteger(app, "--steps", options.steps, 1, 1'000'000, "default: the scenes'");
  addIntegers(app, "--threads", options.threads, kMostThreads,
              "of ours; one thread always runs (default 1,2)");
  app.add_option_function<std::string>(
         "--minutes",
         [&](const std::string& text) {
           const Range range = Range::between(0.1, 1000);
           parseOption("--minutes", text, fmt::format("a number {}", range.text()),
                       [&] { options.minutes = parseNumber(text, range); });
         },
         "for all; scenes have fewer rounds, or are left out, for want of time (default 25)")
      ->type_name("MINUTES");
  addPath(app, "--out", options.out, "FOLDER", "for all files (default out/speed)");
  app.add_flag("--quick", isQuick,
               "a rough look: 2 rounds of 60 steps of scenes that are soon done");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};
  if (isQuick) beQuick(app, options);
  return options;
}

World worldOf(const SpeedScene& scene, const SpeedMethod& method) {
  const Scene& made = findScene(scene.scene);
  World world = makeScene(made, static_cast<std::size_t>(scene.balls));
  if (!made.sleeping) world.settings.sleepSpeed = 0;
  apply(method, world.settings);
  return world;
}

/// Of the default and of the tuned settings.
std::vector<StageRow> stagesOf(const SpeedResult& result) {
  std::vector<StageRow> rows;
  for (const SpeedRow& row : result.rows) {
    const SpeedMethod& method = row.method;
    const bool isDefault = method == SpeedMethod{};
    if (method.isBullet() || method.threads > 1 || !(isDefault || method.substeps > 0)) continue;
    rows.push_back(runStages(result.scene->name, name(method), *makeEngine("ours"),
                             worldOf(*result.scene, method), result.steps));
  }
  return rows;
}

std::vector<WakeRow> wakingOf(const SpeedScene& scene) {
  World world = worldOf(scene, {});
  const auto stepper = makeEngine("ours");
  fallAsleep(*stepper, world, [](std::int64_t) {});
  return wakeCost(*stepper, world);
}

/// All that was measured so far.
struct SpeedReport {
  std::string head;  // what was run, and with what
  std::vector<SpeedResult> results = {};
  std::vector<StageRow> stages = {};
  std::vector<WakeRow> waking = {};
};

std::string reportText(const SpeedReport& report) {
  std::string text = report.head + "\n";
  for (const SpeedResult& result : report.results) text += speedText(result) + "\n";
  text += fmt::format(
      "kept: FAIL where two balls overlap by more than the bound, ground or wall by more than {} "
      "m, "
      "a ball has escaped, or contacts have added energy\n"
      "B/ball: resident memory of engine and world a ball, where it was most\n\n",
      kArenaBound);
  text += stageText(report.stages);
  if (!report.waking.empty())
    text +=
        fmt::format("\n{}, all asleep, some thrown\n{}", kSleepingScene, wakeText(report.waking));
  return text;
}

void write(const SpeedReport& report, const fs::path& folder) {
  writeAtomically(folder / "speed.txt", reportText(report));
  writeAtomically(folder / "speed.csv", speedCsv(report.results));
  writeAtomically(folder / "stages.csv", stageCsv(report.stages));
  if (!report.waking.empty()) writeAtomically(folder / "waking.csv", wakeCsv(report.waking));
}

/// A scene's rounds are spread over the whole time, as the machine's moods are. On disk after each:
/// a run that is ended early leaves what it has.
void runAll(const SpeedOptions& options, SpeedReport& report) {
  const StatusLine line;
  SpeedRunner runner(options, [&](const std::string& text) { line.show(text); });
  for (const std::string& name : options.scenes)
    report.results.push_back(runner.begin(findSpeedScene(name)));
  for (std::int64_t round = 0; round < options.repeats; ++round)
    for (SpeedResult& result : report.results) {
      if (!runner.hasTimeFor(result)) continue;
      runner.addRound(result);
      if (result.rounds() == 1) {
        line.show(fmt::format("{}, stages", result.scene->name));
        for (StageRow& row : stagesOf(result)) report.stages.push_back(std::move(row));
        if (result.scene->name == kSleepingScene) report.waking = wakingOf(*result.scene);
      }
      write(report, options.out);
    }
  write(report, options.out);
}

}  // namespace

int runSpeedBench(std::span<const std::string> arguments, char** argv) {
  const std::optional<SpeedOptions> options = parse(arguments);
  if (!options) return 0;
  becomeExecutableOf("ours", argv);  // the one that starts the other
  makeFolder("--out", options->out);
  std::vector<std::string> command = {"./run.sh bench speed"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  SpeedReport report{buildText(joined(command, " "))};
  runAll(*options, report);
  fmt::print("{}", reportText(report));
  if (const std::string script = speedScript(report.results); !script.empty()) {
    writeAtomically(options->out / "speed.gp", script);
    runGnuplot(options->out, "speed.gp");
  }
  fmt::print("Tables and plot: {}\n", options->out.string());
  return 0;
}

}  // namespace wells
