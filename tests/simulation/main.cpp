// gravity-wells-simulate: one seed with its event log, or many with a summary.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>

#include "errors.h"
#include "progress.h"
#include "simulation/coverage.h"
#include "simulation/run_seeds.h"
#include "simulation/shrink.h"
#include "simulation/simulate_options.h"

namespace wells::simulation {
namespace {

int runSeed(std::uint64_t seed, const SessionShape& shape) {
  const Schedule schedule = drawSchedule(seed, shape);
  const Outcome outcome = simulate(schedule, Trace::Keeping::Everything);
  fmt::print("{}{}", describe(schedule), outcome.trace);
  if (outcome.violations.empty()) {
    fmt::print("all promises kept; {} hand-overs, {} adoptions\n", outcome.tally.handovers,
               outcome.tally.adoptions);
    return 0;
  }
  const Schedule shortest = shrink(schedule, outcome.violations.front().invariant);
  const Outcome again = simulate(shortest, Trace::Keeping::Everything);
  fmt::print("\nthe shortest schedule found that still breaks the promise:\n{}{}",
             describe(shortest), again.trace);
  return kExitFailure;
}

void printSummary(const SeedsOutcome& outcome, double wallTime) {
  const Tally& t = outcome.tally;
  fmt::print("runs                  {}\n", t.runs);
  fmt::print("simulated time        {:.2f} h, {:.0f} times as fast as real time\n",
             t.seconds / 3600, t.seconds / wallTime);
  fmt::print("messages              {} sent, {} accepted, {} refused, {} lost in full buffers\n",
             t.messagesSent, t.messagesReceived, t.messagesRefused, t.messagesLostInBuffers);
  fmt::print("hand-overs            {}, at least {} in each run, less than {} in {} runs\n",
             t.handovers, t.leastHandovers, kFewHandovers, outcome.fewHandovers.size());
  fmt::print("adoptions             {}\n", t.adoptions);
  fmt::print("own stalls noticed    {}\n", t.fences);
  fmt::print("changes of generation {}\n", t.resyncs);
  fmt::print("doubled ball-seconds  {:.1f} of {:.0f}\n", t.doubledBallSeconds, t.ballSeconds);
  fmt::print("faults               ");
  for (std::size_t kind = 0; kind < kFaultKinds; ++kind)
    fmt::print(" {} {}{}", t.faults[kind], kFaultNames[kind], kind + 1 < kFaultKinds ? "," : "\n");
  for (const Failure& failure : outcome.failures)
    fmt::print("seed {}: at {:.3f} s, \"{}\": {}\n", failure.seed, failure.violation.time,
               name(failure.violation.invariant), failure.violation.what);
  for (const std::uint64_t seed : outcome.fewHandovers)
    fmt::print("few hand-overs: seed {}\n", seed);
  fmt::print("violations            {}\n", outcome.failures.size());
}

int runMany(const SimulateOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Clock::time_point shown = begin;
  SeedsOutcome outcome;
  {
    const StatusLine line;
    outcome =
        runSeeds(static_cast<std::uint64_t>(options.first), options.seeds, options.shape,
                 static_cast<int>(options.jobs), [&](const Tally& tally, std::size_t failures) {
                   if (Clock::now() - shown < std::chrono::milliseconds(200)) return;
                   shown = Clock::now();
                   line.show(fmt::format("{} of {} seeds, {} violations", tally.runs, options.seeds,
                                         failures));
                 });
  }
  printSummary(outcome, std::chrono::duration<double>(Clock::now() - begin).count());
  if (!options.coverage.empty()) {
    std::ofstream file(options.coverage);
    file << coverageTable(outcome.tally);
    if (!file.flush())
      throw RunError(fmt::format("--coverage {}: cannot be written", options.coverage.string()));
    for (const std::string& cell : emptyCells(outcome.tally.coverage))
      fmt::print("never hit: {}\n", cell);
  }
  return outcome.failures.empty() ? 0 : kExitFailure;
}

int run(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto options = parseSimulateOptions(arguments);
  if (!options) return 0;
  if (options->seed) return runSeed(static_cast<std::uint64_t>(*options->seed), options->shape);
  return runMany(*options);
}

}  // namespace
}  // namespace wells::simulation

int main(int argc, char** argv) {
  try {
    return wells::simulation::run(argc, argv);
  } catch (const wells::UsageError& error) {
    fmt::print(stderr, "gravity-wells-simulate: {}\n", error.what());
    return wells::kExitUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "gravity-wells-simulate: {}\n", error.what());
    return wells::kExitFailure;
  }
}
