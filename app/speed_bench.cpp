#include "speed_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "bench_row.h"
#include "bench_settling.h"
#include "build_info.h"
#include "command_line.h"
#include "engines.h"
#include "gnuplot.h"
#include "progress.h"
#include "scenes/catalogue.h"
#include "speed_run.h"
#include "speed_table.h"
#include "stage_times.h"
#include "text_file.h"
#include "values.h"
#include "wake_cost.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostThreads = 64;
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
      "AxB has A substeps of B solver passes, the cheapest that keep the overlap of T1 with 10,000 "
      "balls below 0.086 m and 0.049 m.\n"
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
  app.add_option_function<std::string>(
         "--threads",
         [&](const std::string& text) {
           options.threads.clear();
           parseOption("--threads", text, "whole numbers 1 to 64, with commas between them", [&] {
             for (const std::string_view word : splitAtCommas(text))
               options.threads.push_back(parseInteger(trimmed(word), 1, kMostThreads));
           });
         },
         "of ours; one thread always runs (default 1,2)")
      ->type_name("COUNT,...");
  app.add_option_function<std::string>(
         "--minutes",
         [&](const std::string& text) {
           const Range range = Range::between(0.1, 1000);
           parseOption("--minutes", text, fmt::format("a number {}", range.text()),
                       [&] { options.minutes = parseNumber(text, range); });
         },
         "for all; scenes have fewer rounds, or are left out, where it is over (default 12)")
      ->type_name("COUNT");
  app.add_option_function<std::string>(
         "--out", [&](const std::string& value) { options.out = value; },
         "for all files (default out/speed)")
      ->type_name("FOLDER");
  app.add_flag("--quick", isQuick,
               "a rough look: 2 rounds of 60 steps of scenes that are soon done");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};
  if (isQuick) beQuick(app, options);
  return options;
}

std::string conditions(std::span<const std::string> arguments) {
  return fmt::format(
      "command    ./run.sh bench speed {}\ncommit     {}\ncompiler   {}\nflags      {}\n"
      "processor  {}\n\n",
      joined({arguments.data(), arguments.size()}, " "), build_info::kCommit, build_info::kCompiler,
      build_info::kFlags, processorInUse());
}

World worldOf(const SpeedScene& scene, const SpeedMethod& method) {
  const Scene& made = findScene(scene.scene);
  World world = makeScene(made, static_cast<std::size_t>(scene.balls));
  if (!made.sleeping) world.settings.sleepSpeed = 0;
  apply(method, world.settings);
  return world;
}

/// Of the default, and of what was chosen for heaps.
std::vector<StageRow> stagesOf(const SpeedResult& result) {
  std::vector<StageRow> rows;
  for (const SpeedRow& row : result.rows) {
    if (row.method.isBullet() || !row.method.contacts.empty() || row.method.threads > 1) continue;
    rows.push_back(runStages(result.scene->name, name(row.method), *makeEngine("ours"),
                             worldOf(*result.scene, row.method), result.steps));
  }
  return rows;
}

std::vector<WakeRow> wakingOf(const SpeedScene& scene) {
  World world = worldOf(scene, {});
  const auto stepper = makeEngine("ours");
  fallAsleep(*stepper, world, [](std::int64_t) {});
  return wakeCost(*stepper, world);
}

/// All that was measured so far, on disk at once: a run that is ended early leaves what it has.
class SpeedFiles {
 public:
  SpeedFiles(const SpeedOptions& options, std::string conditionsText)
      : folder_(options.out), text_(std::move(conditionsText)) {}

  /// A part of the text, printed too.
  void say(const std::string& part) {
    fmt::print("{}\n", part);
    std::fflush(stdout);
    text_ += part + "\n";
    writeAtomically(folder_ / "speed.txt", text_);
  }

  void write(const char* file, const std::string& text) const {
    writeAtomically(folder_ / file, text);
  }

 private:
  fs::path folder_;
  std::string text_;
};

void runAll(const SpeedOptions& options, SpeedFiles& files) {
  const StatusLine line;
  SpeedRunner runner(options, [&](const std::string& text) { line.show(text); });
  std::vector<SpeedResult> results;
  std::vector<StageRow> stages;
  for (const std::string& name : options.scenes) {
    const SpeedScene& scene = findSpeedScene(name);
    if (runner.isOutOfTime()) {
      files.say(fmt::format("{}: left out, the time was over\n", name));
      continue;
    }
    results.push_back(runner.run(scene));
    line.show(fmt::format("{}, stages", name));
    for (StageRow& row : stagesOf(results.back())) stages.push_back(std::move(row));
    line.show("");
    files.say(speedText(results.back()));
    files.write("speed.csv", speedCsv(results));
    files.write("stages.csv", stageCsv(stages));
  }
  files.say(stageText(stages));
  if (std::ranges::find(options.scenes, kSleepingScene) != options.scenes.end()) {
    const std::vector<WakeRow> waking = wakingOf(findSpeedScene(kSleepingScene));
    files.write("waking.csv", wakeCsv(waking));
    files.say(fmt::format("{}, all asleep, some thrown\n{}", kSleepingScene, wakeText(waking)));
  }
  files.write("speed.gp", speedScript(results));
}

}  // namespace

int runSpeedBench(std::span<const std::string> arguments, char** argv) {
  const std::optional<SpeedOptions> options = parse(arguments);
  if (!options) return 0;
  becomeExecutableOf("ours", argv);  // the one that starts the other
  makeFolder("--out", options->out);
  SpeedFiles files(*options, conditions(arguments));
  runAll(*options, files);
  runGnuplot(options->out, "speed.gp");
  fmt::print("Tables and plot: {}\n", options->out.string());
  return 0;
}

}  // namespace wells
