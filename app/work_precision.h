// What can be said about runs of one case with many step sizes: error against CPU time. Numbers in,
// numbers out; runs nothing and writes nothing. Errors are in the unit of the case's kind of error
// (scenes/exact_answers.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "state/contact_shares.h"

namespace wells {

/// An engine with the settings that it has a choice of.
struct Method {
  std::string engine;
  std::string integrator;
  std::string contacts;

  friend bool operator==(const Method&, const Method&) = default;
};

/// "ours pefrl exact"; the other engines have no choice: "bullet".
std::string name(const Method& method);

/// One step size.
struct WorkPoint {
  double dt = 0;  // s
  std::int64_t steps = 0;
  double error = 0;          // infinite if a state is not finite
  double energyError = 0;    // of the energies' magnitudes at the start; NaN where friction or
                             // inelastic impacts take energy by right
  std::int64_t escaped = 0;  // balls below the ground or beyond the wall at the end
  double cpu = 0;            // s, of the steps alone
  std::int64_t repeats = 0;  // of which `cpu` is the median
  std::uint64_t stateHash = 0;
  ContactShares shares;
  std::optional<Books> books;  // nothing where the engine keeps none
};

/// One method with ever smaller steps.
struct Ladder {
  Method method;
  std::vector<WorkPoint> points;   // falling dt
  std::vector<std::string> notes;  // what was not run, and why
};

/// The numbers of steps in which `duration` (s) is run: its nearest divisors to `coarsest` (s),
/// coarsest/2, coarsest/4 ... At least 2 steps, each number once.
std::vector<std::int64_t> stepLadder(double duration, double coarsest, int rungs);

/// Of an even number of values the mean of the middle two; of none NaN.
double median(std::vector<double> values);

/// The p of error ~ dt^p, by least squares over the finest six points that are neither spoilt by
/// rounding nor too coarse to show an order. Empty where there are fewer than three.
std::optional<double> fittedOrder(std::span<const WorkPoint> points);

/// Whether smaller steps have stopped paying: of at least eight points the last has an error below
/// 1e-10, and no smaller one than twice the halving before.
bool isAtRounding(std::span<const WorkPoint> points);

/// The least CPU time (s) at which `points` are within `error`, between two points by a
/// straight line in the logarithms. Empty: never. A single lucky point counts.
std::optional<double> cheapest(std::span<const WorkPoint> points, double error);

/// How soon the best of some methods is within an error.
struct Reach {
  std::optional<double> cpu;  // s; empty: none ever is
  std::string method;         // that one
  double tried = 0;           // s, the longest run; of several methods the one with the least
};

/// Ladders without points don't count.
Reach soonest(std::span<const Ladder> ladders, double error);

/// How many times the CPU time of `ours` the others need: "312", ">= 2500 (never reached)",
/// "ours never reached it", "not run".
std::string ratioText(const Reach& ours, const Reach& theirs);

}  // namespace wells
