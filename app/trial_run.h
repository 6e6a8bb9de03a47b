// What a trial is made of: runs of one world with different methods and steps, where the balls are
// at a few times of each, and what it cost. Draws no conclusion.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "state/world.h"

namespace wells {

/// A world at the start of a trial, and what must be done to it before each step (nothing if empty:
/// well tracks that grow, say).
struct TrialStart {
  World world;
  std::function<void(World&)> beforeStep;
};

/// Makes the same world for any step dt (s), since keyframes are counted in steps.
using TrialWorld = std::function<TrialStart(double dt)>;

/// What is chosen besides dt.
struct TrialMethod {
  std::string integrator;
  ContactMethod contacts = ContactMethod::Auto;
  int substeps = 4;

  friend bool operator==(const TrialMethod&, const TrialMethod&) = default;
};

/// "pefrl auto".
std::string name(const TrialMethod& method);

/// A method with the longest step found with which it is within the error, or with which it was
/// given up.
struct TriedMethod {
  TrialMethod method;
  double dt = 0;     // s
  double error = 0;  // m, largest distance from the reference, and the reference's own; if reached
  double work = 0;   // s, estimated, for the trial
  bool isReached = false;
};

/// s, to be chosen: longer steps would show in pictures.
inline constexpr double kLongestStep = 2.0 / 15;

/// s, to be chosen.
inline constexpr double kShortestStep = 1e-6;

/// What bounds a trial, all its runs together but for the last: s, estimated, and s of wall time
/// for worlds whose cost the estimate misses.
inline constexpr double kMostTrialWork = 6;
inline constexpr double kMostTrialTime = 30;

struct TrialGoal {
  double error = 0;                   // m
  double duration = 0;                // s, of the run that the choice is for
  double dt = 0;                      // s, what the world has now
  TrialMethod method;                 // likewise
  double longestStep = kLongestStep;  // s, to be chosen
};

/// No choice can be made; what() says why and what to change.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The times at which runs are compared: multiples of `interval`. All runs have whole steps in it.
struct TrialTimes {
  double interval = 0;  // s
  int count = 0;

  double duration() const { return interval * count; }  // s
  double dt(std::int64_t stepsPerInterval) const {      // s
    return interval / static_cast<double>(stepsPerInterval);
  }
};

/// Positions (m) by ball.
using Positions = std::vector<Vec3>;

struct TrialRun {
  std::vector<Positions> samples;  // at interval, 2 interval ...
  std::int64_t steps = 0;          // that were made
  double work = 0;                 // s, estimated (stepWork), of these
  bool usedSubsteps = false;       // some ball was moved by substeps
  /// In use: not the one asked for, where the integrator forbids that.
  ContactMethod contacts = ContactMethod::Auto;
};

/// What stops a run early, so that it has fewer samples than it should.
struct TrialStop {
  double work = std::numeric_limits<double>::infinity();  // s; more than this
  std::function<bool(const Positions&, int)> goesOn;      // asked at each sample; empty: always
};

/// Runs a world, and adds up what the runs cost.
class Trials {
 public:
  /// Both must outlive this. `progress` is called with what is tried next.
  Trials(const TrialWorld& world, const std::function<void(const std::string&)>& progress)
      : world_(world), progress_(progress) {}

  /// With `stepsPerInterval` steps in each interval of `times`. Horizontal positions are first
  /// changed by `nudge` (m), from ball to ball in other directions. What the engine throws passes
  /// through.
  TrialRun run(const TrialMethod& method, const TrialTimes& times, std::int64_t stepsPerInterval,
               const TrialStop& stop, double nudge = 0);

  World start(double dt) const { return world_(dt).world; }
  void say(const std::string& what) const { progress_(what); }

  /// s, estimated, that is left.
  double workLeft() const { return kMostTrialWork - work_; }

  /// Of what bounds the trial; 1: all.
  double spent() const;

 private:
  using Clock = std::chrono::steady_clock;

  const TrialWorld& world_;
  const std::function<void(const std::string&)>& progress_;
  Clock::time_point start_ = Clock::now();
  double work_ = 0;  // s, estimated
};

/// The largest distance (m) of a ball between two samples; infinite where only one is finite.
double largestDistance(const Positions& a, const Positions& b);

}  // namespace wells
