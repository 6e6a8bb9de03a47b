#include "peer_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command_line.h"
#include "config_file.h"
#include "engines.h"
#include "errors.h"
#include "keys.h"
#include "network/lcm_url.h"
#include "saved_config.h"
#include "snapshot_file.h"
#include "target_error.h"
#include "text_file.h"
#include "values.h"
#include "world_setup.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

// Other spellings of keys on the command line.
constexpr std::pair<std::string_view, std::string_view> kAliases[] = {
    {"Dt", "--dt"},
    {"Integrator", "--integrator"},
    {"PeerID", "--peer-id"},
    {"Threads", "--threads"}};

constexpr double kLongestRun = 1e9;  // s, steps

// What the command line says that does not stand in PeerOptions as it is.
struct Words {
  fs::path configFile;
  fs::path restoreFile;
  std::vector<Setting> settings;
  std::optional<std::string> engine;
  std::optional<std::int64_t> steps;
};

double parseTime(const std::string& option, const std::string& value) {
  const Range range = Range::above(0, kLongestRun);
  double time = 0;  // s
  parseOption(option, value, fmt::format("a number {}, in s", range.text()),
              [&] { time = parseNumber(value, range); });
  return time;
}

std::string optionNamesOf(const Key& key) {
  std::string names = "--" + key.name;
  for (const auto& [name, alias] : kAliases)
    if (name == key.name) names += fmt::format(",{}", alias);
  return names;
}

void addKeys(CLI::App& app, std::vector<Setting>& settings) {
  for (const Key& key : keys()) {
    const auto collect = [&settings, name = key.name](const std::vector<std::string>& values) {
      for (const std::string& value : values) settings.push_back({.key = name, .value = value});
    };
    app.add_option_function<std::vector<std::string>>(
           optionNamesOf(key), collect, fmt::format("{}. Allowed: {}", key.help, key.allowed))
        ->type_size(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("VALUE")
        ->default_str(key.defaultText())
        ->group(key.group);
  }
}

void addRunOptions(CLI::App& app, PeerOptions& options, Words& words) {
  const std::string group = "Run";
  addPath(app, "--config", words.configFile, "FILE",
          "config file of KEY=VALUE lines; options override it")
      ->group(group);
  app.add_flag_function(
         "--solo", [&](std::int64_t) { options.company = Company::Solo; },
         "alone: no network, as fast as possible")
      ->group(group);
  app.add_option_function<std::string>(
         "--duration",
         [&](const std::string& value) { options.duration = parseTime("--duration", value); },
         "simulated time after which to stop; else it runs until Ctrl-C")
      ->type_name("s")
      ->group(group);
  app.add_option_function<std::string>(
         "--steps",
         [&](const std::string& value) {
           const auto most = static_cast<std::int64_t>(kLongestRun);
           parseOption("--steps", value, fmt::format("a whole number 0 to {}", most),
                       [&] { words.steps = parseInteger(value, 0, most); });
         },
         "steps after which to stop, instead of --duration")
      ->type_name("COUNT")
      ->group(group);
  app.add_option_function<std::string>(
         "--engine",
         [&](const std::string& value) {
           requireEngine(value);
           words.engine = value;
         },
         joined(engineNames(), ", "))
      ->type_name("NAME")
      ->default_str("ours")
      ->group(group);
  addInstructions(app, group);
  app.add_flag("--quiet", options.quiet, "no progress and no notices")->group(group);
}

void addTargetError(CLI::App& app, PeerOptions& options) {
  app.add_option_function<std::string>(
         "--target-error",
         [&](const std::string& value) { options.targetError = parseTargetError(value); },
         targetErrorHelp() +
             ". With --solo: in a session all peers need the same, so put the lines that it prints "
             "into everybody's config")
      ->type_name("m")
      ->group("Run");
}

void addSnapshotOptions(CLI::App& app, PeerOptions& options, Words& words) {
  const std::string group = "Snapshot (with --solo)";
  addPath(app, "--save-snapshot", options.snapshot, "FILE",
          "writes the world at the end, with all that a run needs to go on from it")
      ->group(group);
  app.add_option_function<std::string>(
         "--save-snapshot-every",
         [&](const std::string& value) {
           options.saveInterval = parseTime("--save-snapshot-every", value);
         },
         "simulated time after which --save-snapshot writes its file anew")
      ->type_name("s")
      ->group(group);
  addPath(
      app, "--restore", words.restoreFile, "FILE",
      "goes on from a snapshot: with its world, this peer's well and engine, and the same bits; "
      "--duration and --steps count from there")
      ->group(group);
}

void addNetworkOptions(CLI::App& app, PeerOptions& options) {
  const std::string group = "Network";
  app.add_option_function<std::string>(
         "--lcm-url",
         [&](const std::string& value) {
           try {
             options.lcmUrl = parseLcmUrl(value).text();
           } catch (const LcmUrlError& error) {
             throw UsageError(
                 fmt::format("--lcm-url {}: {}; allowed: "
                             "udpm://GROUP:PORT?ttl=HOPS&recv_buf_size=BYTES",
                             value, error.what()));
           }
         },
         "of the session, instead of the one made from UDPPort, which stays on this host (ttl=0; "
         "ttl=1 reaches the LAN)")
      ->type_name("URL")
      ->group(group);
  app.add_flag("--require-lcm", options.requireLcm,
               "exit with status 1 where multicast does not pass, instead of running alone")
      ->group(group);
}

void addOutputOptions(CLI::App& app, PeerOptions& options) {
  const std::string group = "Output";
  addPath(app, "--frames", options.frames, "FOLDER", "writes each frame as PNG into this folder")
      ->group(group);
  addPath(app, "--video", options.video, "FILE", "writes the frames as MP4 (needs ffmpeg)")
      ->group(group);
  addPath(app, "--last-frame", options.lastFrame, "FILE", "writes the last frame as PNG")
      ->group(group);
  addPath(app, "--state-out", options.stateOut, "FILE",
          "writes all balls at the end as CSV, 17 digits, as BallsFile reads it")
      ->group(group);
  addPath(app, "--report", options.report, "FILE", "writes what was measured as JSON")
      ->group(group);
  app.add_flag("--measures", options.measures,
               "books energy and momentum by source, for the summary and --report; costs time")
      ->group(group);
}

void requireOutputs(const PeerOptions& options) {
  const std::pair<const char*, const fs::path&> files[] = {{"--video", options.video},
                                                           {"--last-frame", options.lastFrame},
                                                           {"--state-out", options.stateOut},
                                                           {"--report", options.report},
                                                           {"--save-snapshot", options.snapshot}};
  for (const auto& [name, file] : files)
    if (!file.empty()) requireWritable(name, file);
  if (!options.frames.empty()) requireFolder("--frames", options.frames);
}

void restore(PeerOptions& options, const fs::path& file) {
  options.restored = readSnapshot(file);
  options.config = restoredConfig(*options.restored, file);
  const auto& wells = options.restored->world.tracks;
  if (!wells.empty() && value(wells.back().peer) == options.config.peerId) return;
  throw UsageError(
      fmt::format("{}: its last well is not that of peer {}; allowed: a snapshot that "
                  "--save-snapshot wrote",
                  file.string(), options.config.peerId));
}

void applyConfig(PeerOptions& options, const Words& words) {
  std::vector<Setting> fromFile;
  if (!words.configFile.empty()) fromFile = readConfigFile(words.configFile);
  options.notices = applySettings(options.config, fromFile);
  applySettings(options.config, words.settings);
  if (options.restored) {
    requireAsSaved(*options.restored, options.config, words.settings);
    requireAsSaved(*options.restored, options.config, fromFile);
  }
  for (const Setting& setting : words.settings)
    if (setting.key == "PeerID") options.idOrigin = IdOrigin::CommandLine;
}

void applyEngine(PeerOptions& options, const Words& words) {
  if (options.restored) {
    options.engine = options.restored->engine;
    requireEngine(options.engine);
  }
  if (!words.engine) return;
  if (options.restored && *words.engine != options.engine) {
    throw UsageError(
        fmt::format("--engine {}: contradicts the snapshot; allowed with --restore: {}, or nothing",
                    *words.engine, options.engine));
  }
  options.engine = *words.engine;
}

void applyTimes(PeerOptions& options, const Words& words) {
  if (words.steps && options.duration)
    throw UsageError("--steps and --duration: both given; allowed: one of them");
  if (words.steps)
    options.steps = (options.restored ? options.restored->world.step : 0) + *words.steps;
  if (options.saveInterval && options.snapshot.empty())
    throw UsageError("--save-snapshot-every: no file is named; allowed: with --save-snapshot");
  countSteps(options);
}

/// A trial chooses what sessions, snapshots and numbers of steps need to know before.
void requireTrial(const PeerOptions& options, const Words& words) {
  if (options.targetError == 0) return;
  if (options.company == Company::Session)
    throw UsageError(
        "--target-error: all peers of a session need the same Dt, Integrator, ContactMethod and "
        "Substeps; allowed: with --solo, which prints them for everybody's config");
  if (options.restored)
    throw UsageError(
        "--target-error and --restore: a snapshot goes on with its own Dt; allowed: one of them");
  if (words.steps)
    throw UsageError(
        "--target-error and --steps: how long a step is will be chosen; allowed: --duration");
  if (options.engine != "ours")
    throw UsageError(fmt::format(
        "--target-error: chooses for ours, not for {}; allowed: --engine ours", options.engine));
}

void place(PeerOptions& options) {
  options.places = placeThreads(options.config, {.graphics = options.drawsPictures(),
                                                 .network = options.company == Company::Session});
  const std::size_t cores = options.places.simulation.size();
  if (cores > 0 && static_cast<std::size_t>(options.places.simulationThreads) > cores)
    options.notices.push_back(
        fmt::format("Threads={}: more than the simulation has cores ({}): "
                    "they will wait for each other",
                    options.places.simulationThreads, cores));
}

void requireConsistent(const PeerOptions& options) {
  const bool session = options.company == Company::Session;
  if (session && options.restored)
    throw UsageError("--restore: a session has no world of one peer; allowed: with --solo");
  if (session && !options.snapshot.empty())
    throw UsageError("--save-snapshot: a session has no world of one peer; allowed: with --solo");
  if (session) return;
  if (options.requireLcm)
    throw UsageError("--solo and --require-lcm: contradict each other; allowed: one of them");
  if (!options.lcmUrl.empty())
    throw UsageError("--solo and --lcm-url: contradict each other; allowed: one of them");
}

}  // namespace

void countSteps(PeerOptions& options) {
  const double dt = stepLength(options.config, options.engine);
  const std::int64_t first = options.restored ? options.restored->world.step : 0;
  if (options.duration) options.steps = first + std::llround(*options.duration / dt);
  if (options.saveInterval)
    options.snapshotEvery = std::max<std::int64_t>(1, std::llround(*options.saveInterval / dt));
}

std::optional<PeerOptions> parsePeerOptions(std::span<const std::string> arguments) {
  PeerOptions options;
  Words words;
  CLI::App app("Runs one peer of a gravity-wells session, or a world alone (--solo).",
               "gravity-wells peer");
  addRunOptions(app, options, words);
  addTargetError(app, options);
  addSnapshotOptions(app, options, words);
  addNetworkOptions(app, options);
  addOutputOptions(app, options);
  addKeys(app, words.settings);
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};

  if (!words.restoreFile.empty()) restore(options, words.restoreFile);
  applyConfig(options, words);
  applyEngine(options, words);
  applyTimes(options, words);
  requireConsistent(options);
  requireTrial(options, words);
  requireOutputs(options);
  place(options);
  return options;
}

}  // namespace wells
