#include "bench.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "accuracy_bench.h"
#include "bench_run.h"
#include "bench_settling.h"
#include "command_line.h"
#include "curve_bench.h"
#include "engines.h"
#include "errors.h"
#include "feature_bench.h"
#include "flight/integrators.h"
#include "progress.h"
#include "scenes/catalogue.h"
#include "speed_bench.h"
#include "stress_bench.h"
#include "target_error.h"
#include "text_file.h"
#include "threads/thread_pool.h"
#include "values.h"
#include "work_precision.h"
#include "world/settling.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostBalls = 1'000'000;
constexpr std::int64_t kMostSteps = 1'000'000'000;

struct BenchOptions {
  std::string scene = "T1";
  std::string engine = "ours";
  std::string from = "start";
  std::string integrator;       // empty: the scene's
  std::string contacts;         // empty: the scene's
  std::int64_t balls = 0;       // 0: the scene's default
  std::int64_t steps = 0;       // 0: the scene's default
  std::int64_t substeps = 0;    // 0: the scene's
  std::int64_t iterations = 0;  // 0: the scene's
  std::int64_t threads = 1;
  std::int64_t runs = 1;
  std::int64_t seed = 1;
  double dt = 0;           // s; 0: the scene's
  double targetError = 0;  // m; 0: none
  fs::path csv;
  bool list = false;
  bool noBooks = false;
};

void addOptions(CLI::App& app, BenchOptions& options) {
  addName(app, "--scene", options.scene, "what to simulate; --list shows all (default T1)",
          [](std::string_view name) { findScene(name); });
  addName(app, "--engine", options.engine, joined(engineNames(), ", ") + " (default ours)",
          [](std::string_view name) { requireEngine(name); });
  addName(app, "--integrator", options.integrator, "of ours (default: the scene's)",
          [](std::string_view name) { findIntegrator(name); });
  addName(app, "--contacts", options.contacts,
          fmt::format("contact method of ours: {} (default: the scene's)",
                      fmt::join(kContactMethodNames, ", ")),
          [](std::string_view name) {
            if (!contactMethod(name))
              throw std::invalid_argument(fmt::format("no such contact method; allowed: {}",
                                                      fmt::join(kContactMethodNames, ", ")));
          });
  addName(
      app, "--from", options.from,
      fmt::format("start, or settled: what is reported begins when the kinetic energy has been "
                  "below {:g} of its peak for {} s; asleep: when all balls of ours sleep (default "
                  "start)",
                  kSettledShare, kSettledTime),
      [](std::string_view name) {
        if (name != "start" && name != "settled" && name != "asleep")
          throw std::invalid_argument("no such moment; allowed: start, settled, asleep");
      });
  addInteger(app, "--balls", options.balls, 1, kMostBalls, "default: the scene's");
  addInteger(app, "--steps", options.steps, 1, kMostSteps, "default: the scene's");
  addInteger(app, "--substeps", options.substeps, 1, 1000, "of ours (default: the scene's)");
  addInteger(app, "--iterations", options.iterations, 1, 1000, "of ours (default: the scene's)");
  addInteger(app, "--threads", options.threads, 1, kMostThreads,
             "of the simulation; the result has the same bits for any number (default 1)");
  addInstructions(app);
  addInteger(app, "--runs", options.runs, 1, 1000,
             "of the same steps, each with a new engine; the median of their times counts "
             "(default 1)");
  addInteger(app, "--seed", options.seed, 0, std::int64_t{1} << 53,
             "of scenes with chance (default 1)");
  app.add_option_function<std::string>(
         "--dt",
         [&](const std::string& value) {
           const Range range = Range::above(0, 1);
           parseOption("--dt", value, fmt::format("a number {}, in s", range.text()),
                       [&] { options.dt = parseNumber(value, range); });
         },
         "one step (default 1/60)")
      ->type_name("s");
  app.add_option_function<std::string>(
         "--target-error",
         [&](const std::string& value) { options.targetError = parseTargetError(value); },
         targetErrorHelp())
      ->type_name("m");
  app.add_option_function<std::string>(
         "--csv", [&](const std::string& value) { options.csv = value; },
         "appends the row to this file instead of printing it")
      ->type_name("FILE");
  app.add_flag("--no-books", options.noBooks,
               "leaves out the second run, in which ours books where the energy goes");
  app.add_flag("--list", options.list, "lists the scenes and ends");
}

void listScenes() {
  for (const Scene& scene : scenes())
    fmt::print("{:16} {:>6} balls {:>6} steps  {}\n", scene.name, scene.defaultBalls,
               scene.defaultSteps, scene.about);
}

/// Refuses a file whose header is another one, before an hour of benchmark is spent.
void checkCsv(const fs::path& file) {
  requireWritable("--csv", file);
  if (!fs::exists(file) || fs::file_size(file) == 0) return;
  std::string header;
  std::getline(std::ifstream(file), header);
  if (header != csvHeader())
    throw UsageError(
        fmt::format("--csv {}: its first line is \"{}\"; allowed: a new file, or one that "
                    "starts with \"{}\"",
                    file.string(), header, csvHeader()));
}

void appendRow(const fs::path& file, const std::string& row) {
  const bool isNew = !fs::exists(file) || fs::file_size(file) == 0;
  std::ofstream out(file, std::ios::app);
  if (isNew) out << csvHeader() << '\n';
  out << row << '\n';
  out.flush();
  if (!out) throw RunError(fmt::format("--csv {}: could not be written", file.string()));
}

/// What is timed from the start on is timed as other engines were, by scene.
bool maySleep(const BenchOptions& options) {
  return findScene(options.scene).sleeping || options.from != "start";
}

World sceneWorld(const BenchOptions& options) {
  World world;
  try {
    world = makeScene(findScene(options.scene), static_cast<std::size_t>(options.balls),
                      static_cast<std::uint64_t>(options.seed));
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--balls {}: {}", options.balls, error.what()));
  }
  Settings& settings = world.settings;
  if (options.dt > 0) settings.dt = options.dt;
  if (!options.integrator.empty()) settings.integrator = options.integrator;
  if (const auto method = contactMethod(options.contacts)) settings.contactMethod = *method;
  if (options.substeps > 0) settings.substeps = static_cast<int>(options.substeps);
  if (options.iterations > 0) settings.iterations = static_cast<int>(options.iterations);
  if (!maySleep(options)) settings.sleepSpeed = 0;
  return world;
}

void requireTrial(const BenchOptions& options) {
  if (options.targetError == 0) return;
  if (options.engine != "ours")
    throw UsageError(fmt::format(
        "--target-error: chooses for ours, not for {}; allowed: --engine ours", options.engine));
  const std::pair<const char*, bool> chosen[] = {{"--dt", options.dt > 0},
                                                 {"--integrator", !options.integrator.empty()},
                                                 {"--contacts", !options.contacts.empty()},
                                                 {"--substeps", options.substeps > 0},
                                                 {"--from", options.from != "start"}};
  for (const auto& [name, isGiven] : chosen)
    if (isGiven)
      throw UsageError(fmt::format(
          "--target-error and {}: they exclude each other; allowed: one of them", name));
}

/// Puts the choice of --target-error into `world`, says it on stderr, and returns the number of
/// steps that make the same duration.
std::int64_t chooseFor(double targetError, std::int64_t steps, World& world) {
  const double duration = static_cast<double>(steps) * world.settings.dt;
  const auto start = [&world](double dt) {
    World now = world;
    now.settings.dt = dt;
    return TrialStart{now, {}};
  };
  Settings settings = world.settings;
  const Choice choice = chooseSettings(start, targetError, duration, kLongestStep,
                                       ProgressLine::Shown::Yes, settings);
  fmt::print(stderr, "{}", choiceText(choice, targetError, duration));
  world.settings = settings;
  return std::max<std::int64_t>(1, std::llround(duration / settings.dt));
}

/// Calls run(progress) under a progress line.
template <class Run>
auto withProgress(const RunGoal& goal, Run run) {
  const ProgressLine line(goal, ProgressLine::Shown::Yes);
  const auto start = std::chrono::steady_clock::now();
  RunProgress progress;
  return run([&](std::int64_t done) {
    progress.step = done;
    line.show(progress,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  });
}

BenchResult runScene(const BenchOptions& options) {
  const Scene& scene = findScene(options.scene);
  std::int64_t steps = options.steps > 0 ? options.steps : scene.defaultSteps;
  const auto newStepper = [&] {
    return makeEngine(options.engine, maySleep(options) ? Sleeping::On : Sleeping::Off,
                      static_cast<int>(options.threads));
  };
  World world = sceneWorld(options);
  if (options.targetError > 0) steps = chooseFor(options.targetError, steps, world);
  const auto stepper = newStepper();
  const BenchFrom from = options.from == "settled"  ? BenchFrom::Settled
                         : options.from == "asleep" ? BenchFrom::Asleep
                                                    : BenchFrom::Start;
  if (from != BenchFrom::Start)
    withProgress({.dt = world.settings.dt}, [&](const auto& progress) {
      (from == BenchFrom::Settled ? settle : fallAsleep)(*stepper, world, progress);
    });
  const auto booking = newStepper();  // starts where the timed one does
  if (stepper->memory()) booking->restore(*stepper->memory());

  const RunGoal goal{.steps = steps, .dt = world.settings.dt, .hasEnd = true};
  const auto run = [&](Stepper& engine) {
    return withProgress(goal, [&](const auto& progress) {
      return benchmark(engine, world, steps, from, progress);
    });
  };
  BenchResult result = run(*stepper);
  std::vector<double> times = {result.msPerStep};
  std::vector<double> last = {result.msPerStepLast100};
  for (std::int64_t i = 1; i < options.runs; ++i) {
    const BenchResult again = run(*newStepper());
    times.push_back(again.msPerStep);
    last.push_back(again.msPerStepLast100);
  }
  result.msPerStep = median(times);
  result.msPerStepLast100 = median(last);
  if (!options.noBooks)
    result.books = withProgress(
        goal, [&](const auto& progress) { return bookedRun(*booking, world, steps, progress); });
  result.scene = options.scene;
  result.threads = options.threads;
  return result;
}

}  // namespace

int runBench(std::span<const std::string> arguments, char** argv) {
  if (!arguments.empty() && arguments.front() == "accuracy")
    return runAccuracyBench(arguments.subspan(1), argv);
  if (!arguments.empty() && arguments.front() == "stress")
    return runStressBench(arguments.subspan(1), argv);
  if (!arguments.empty() && arguments.front() == "curve")
    return runCurveBench(arguments.subspan(1), argv);
  if (!arguments.empty() && arguments.front() == "speed")
    return runSpeedBench(arguments.subspan(1), argv);
  if (!arguments.empty() && arguments.front() == "features")
    return runFeatureBench(arguments.subspan(1), argv);
  CLI::App app{
      "Runs a scene with an engine; one CSV row of time and physics.\n"
      "ms_per_step is the wall time of the steps alone; overlap, energy and escaped balls "
      "are those at the end. Where the energy went (.._J) is booked in a second run.\n"
      "\"bench accuracy\" measures error against CPU time, \"bench stress\" runs worlds that break "
      "engines, \"bench curve\" overlap against time over the solver's settings, \"bench speed\" "
      "many scenes beside stock Bullet, \"bench features\" what a feature costs that is not used; "
      "all take --help too.",
      "./run.sh bench"};
  BenchOptions options;
  addOptions(app, options);
  if (parseArguments(app, arguments) == Parsed::HelpShown) return 0;
  if (options.list) {
    listScenes();
    return 0;
  }
  requireTrial(options);
  if (options.from == "asleep" && options.engine != "ours")
    throw UsageError(fmt::format(
        "--from asleep: {} does not say who sleeps; allowed: --engine ours", options.engine));
  if (options.from != "start" && options.runs > 1)
    throw UsageError(fmt::format("--runs {}: runs from {} cannot be repeated; allowed: 1",
                                 options.runs, options.from));
  if (!options.csv.empty()) checkCsv(options.csv);
  becomeExecutableOf(options.engine, argv);

  const BenchResult result = runScene(options);
  if (options.csv.empty())
    fmt::print("{}\n{}\n", csvHeader(), csvRow(result));
  else
    appendRow(options.csv, csvRow(result));
  return 0;
}

}  // namespace wells
