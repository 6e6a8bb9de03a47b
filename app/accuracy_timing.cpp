#include "accuracy_timing.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "errors.h"
#include "world/measures.h"

namespace wells {
namespace {

// Runs too short for the clock (a reading takes up to 3 us) are timed several at once, this many at
// most. New engines push each other out of the cache, so of them fewer.
constexpr double kMostWarm = 64;
constexpr double kMostNew = 8;
constexpr std::int64_t kWarmUpSteps = 200;

}  // namespace

double cpuTime() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

StepTiming::StepTiming(const AccuracyTask& task, double shortest, double expected,
                       std::uint64_t stateHash)
    : task_(task),
      shortest_(shortest),
      expected_(expected),
      stateHash_(stateHash),
      stepper_(task.stepper()) {
  if (!stepper_->memory()) return;
  start_ = *stepper_->memory();
  World world = task_.world();
  for (std::int64_t step = 0; step < std::min(task_.steps, kWarmUpSteps); ++step)
    stepper_->step(world);
}

double StepTiming::measure() {
  Part sum;
  while (sum.steps == 0 || sum.time < shortest_) {
    const Part part = stepper_->memory() ? timeWarm() : timeNew();
    sum = {sum.time + part.time, sum.steps + part.steps};
  }
  return sum.time / static_cast<double>(sum.steps) * static_cast<double>(task_.steps);
}

std::size_t StepTiming::together(double most) const {
  return static_cast<std::size_t>(std::clamp(std::ceil(shortest_ / expected_), 1.0, most));
}

/// An engine that can start over does so, with its memory allocated and in the cache.
StepTiming::Part StepTiming::timeWarm() {
  std::vector<World> worlds(together(kMostWarm), task_.world());
  const double start = cpuTime();
  for (World& world : worlds) {
    stepper_->restore(start_);
    for (std::int64_t step = 0; step < task_.steps; ++step) stepper_->step(world);
  }
  const double time = cpuTime() - start;
  requireSameBits(worlds.back());
  return {time, static_cast<std::int64_t>(worlds.size()) * task_.steps};
}

/// One that keeps what cannot be set back (Bullet its contacts) is made anew. It builds its world
/// in its first step, which is not timed; measure() counts that step like the others.
StepTiming::Part StepTiming::timeNew() const {
  struct Run {
    World world;
    std::unique_ptr<Stepper> stepper;
  };
  std::vector<Run> runs(together(kMostNew));
  for (Run& run : runs) {
    run = {task_.world(), task_.stepper()};
    run.stepper->step(run.world);
  }
  const double start = cpuTime();
  for (Run& run : runs)
    for (std::int64_t step = 1; step < task_.steps; ++step) run.stepper->step(run.world);
  const double time = cpuTime() - start;
  requireSameBits(runs.back().world);
  return {time, static_cast<std::int64_t>(runs.size()) * (task_.steps - 1)};
}

void StepTiming::requireSameBits(const World& world) const {
  if (wells::stateHash(world) == stateHash_) return;
  throw RunError(fmt::format("{}, {}, dt = {} s: two runs end with different bits",
                             task_.answer.scene, name(task_.method), task_.dt()));
}

}  // namespace wells
