// One benchmark: a scene, an engine, a number of steps; time of the steps alone, and what the
// physics did.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "bench_settling.h"
#include "state/contact_shares.h"
#include "world/measures.h"

namespace wells {

enum class BenchFrom : std::uint8_t { Start, Settled, Asleep };

struct BenchResult {
  std::string scene;
  std::string engine;
  std::string integrator;
  std::string contacts;
  std::size_t balls = 0;
  double dt = 0;  // s
  std::int64_t steps = 0;
  std::int64_t threads = 1;
  double msPerStep = 0;         // wall time of the step calls, mean
  double msPerStepLast100 = 0;  // of the last 100 steps, or of all if there are fewer
  Measures start;
  Measures end;
  std::int64_t asleep = 0;        // balls, at the end
  std::optional<RestWatch> rest;  // unless from the start
  ContactShares shares;
  std::optional<Books> books;  // of a run of its own; nothing where the engine keeps none
  /// MiB of resident memory, by which the steps made the process grow at most: the engine and the
  /// world that it steps. Only from the start: else the engine holds most of it before.
  std::optional<double> memory;
  std::uint64_t stateHash = 0;
};

/// Steps a copy of `start` and measures before and after; nothing but the steps is timed. Unless
/// from the start, watches what still moves. `progress` is called with the number of steps done,
/// about ten times a second at most.
BenchResult benchmark(Stepper& stepper, const World& start, std::int64_t steps, BenchFrom from,
                      const std::function<void(std::int64_t)>& progress);

/// Steps the same world again with another stepper that keeps books, so that keeping them is not in
/// the times. Nothing where it cannot.
std::optional<Books> bookedRun(Stepper& stepper, World world, std::int64_t steps,
                               const std::function<void(std::int64_t)>& progress);

/// The header line of the CSV file, without line end.
std::string csvHeader();

/// One row: the result, and what the program was built from, with and on.
std::string csvRow(const BenchResult& result);

}  // namespace wells
