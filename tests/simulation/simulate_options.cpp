#include "simulation/simulate_options.h"

#include <algorithm>
#include <thread>

#include "command_line.h"
#include "errors.h"

namespace wells::simulation {

std::optional<SimulateOptions> parseSimulateOptions(std::span<const std::string> arguments) {
  CLI::App app{
      "Simulates sessions with faults drawn from a seed and checks that no ball is lost or "
      "doubled.\n"
      "Without --seed it runs many seeds and sums them up. Exit status 1: a promise was broken.",
      "./run.sh simulate"};
  SimulateOptions options;
  options.jobs = std::max<std::int64_t>(1, std::thread::hardware_concurrency());
  std::int64_t seed = 0;
  std::int64_t peers = options.shape.peers;
  std::int64_t balls = options.shape.balls;
  std::int64_t seconds = static_cast<std::int64_t>(options.shape.seconds);
  constexpr std::int64_t kMostSeeds = 1'000'000'000;
  addInteger(app, "--seed", seed, 0, kMostSeeds,
             "one run: prints its schedule and event log; after a violation also the shortest "
             "schedule found that still breaks the promise, and its log");
  addInteger(app, "--seeds", options.seeds, 1, kMostSeeds, "how many seeds (default 1000)");
  addInteger(app, "--first", options.first, 0, kMostSeeds, "the first of them (default 1)");
  addInteger(app, "--jobs", options.jobs, 1, 256, "threads (default: one for each processor)");
  app.add_option_function<std::string>(
         "--coverage", [&](const std::string& path) { options.coverage = path; },
         "writes the table of faults and the states of the peers that they hit")
      ->type_name("FILE");
  addInteger(app, "--peers", peers, 2, 5, "of the group (default 3)");
  addInteger(app, "--balls", balls, 1, 100, "that they share (default 8)");
  addInteger(app, "--seconds", seconds, 60, 3600, "simulated in each run (default 66)");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return std::nullopt;
  if (app.count("--seed") > 0) {
    for (const char* other : {"--seeds", "--first", "--jobs", "--coverage"})
      if (app.count(other) > 0)
        throw UsageError(std::string(other) +
                         ": does not go with --seed, which is one run; allowed: "
                         "either of them");
    options.seed = seed;
  }
  options.shape = {static_cast<int>(peers), static_cast<int>(balls), static_cast<double>(seconds)};
  return options;
}

}  // namespace wells::simulation
