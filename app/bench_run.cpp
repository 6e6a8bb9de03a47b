#include "bench_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "bench_row.h"
#include "memory_growth.h"

namespace wells {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLastSteps = 100;

double meanMilliseconds(std::span<const Clock::duration> times) {
  if (times.empty()) return 0;
  Clock::duration sum{};
  for (const auto time : times) sum += time;
  return std::chrono::duration<double, std::milli>(sum).count() / static_cast<double>(times.size());
}

}  // namespace

BenchResult benchmark(Stepper& stepper, const World& start, std::int64_t steps, BenchFrom from,
                      const std::function<void(std::int64_t)>& progress) {
  BenchResult result;
  result.balls = start.balls.size();
  result.dt = start.settings.dt;
  result.steps = steps;
  result.start = measure(start);
  if (from != BenchFrom::Start) result.rest.emplace(start);
  std::vector<Clock::duration> times;
  times.reserve(static_cast<std::size_t>(steps));
  const MemoryGrowth memory;
  World world = start;
  Clock::time_point reported = Clock::now();
  for (std::int64_t step = 0; step < steps; ++step) {
    const auto before = Clock::now();
    stepper.step(world);
    const auto after = Clock::now();
    times.push_back(after - before);
    if (result.rest) result.rest->add(world);
    result.shares.add(stepper.counts(), world.balls.size());
    if (after - reported > std::chrono::milliseconds(100)) {
      progress(step + 1);
      reported = after;
    }
  }
  if (from == BenchFrom::Start) result.memory = memory.most();
  const std::size_t last = std::min(times.size(), kLastSteps);
  result.msPerStep = meanMilliseconds(times);
  result.msPerStepLast100 = meanMilliseconds(std::span(times).last(last));
  result.end = measure(world);
  result.asleep = stepper.counts().asleep;
  result.engine = stepper.name();
  result.integrator = stepper.integrator();
  result.contacts = stepper.contactMethod();
  result.stateHash = stateHash(world);
  return result;
}

std::optional<Books> bookedRun(Stepper& stepper, World world, std::int64_t steps,
                               const std::function<void(std::int64_t)>& progress) {
  if (!stepper.openBooks()) return std::nullopt;
  for (std::int64_t step = 0; step < steps; ++step) {
    stepper.step(world);
    if (step % 16 == 0) progress(step + 1);
  }
  return *stepper.books();
}

std::string csvHeader() {
  return fmt::format(
      "scene,engine,integrator,contacts,balls,dt,steps,threads,ms_per_step,ms_per_step_last100,"
      "max_overlap_m,ball_overlap_m,ground_overlap_m,wall_overlap_m,energy_start_J,energy_end_J,"
      "kinetic_start_J,kinetic_end_J,escaped,settled_s,"
      "moved_m,"
      "kinetic_rise_J,asleep,{},memory_MiB,state_hash,{}",
      kStepColumns, kBuildColumns);
}

std::string csvRow(const BenchResult& r) {
  return fmt::format(
      "{},{},{},{},{},{:.17g},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.17g},{:.17g},{:."
      "6g},{:.6g},{},{},{},"
      "{},{},{},{}",
      r.scene, r.engine, csvField(r.integrator), csvField(r.contacts), r.balls, r.dt, r.steps,
      r.threads, r.msPerStep, r.msPerStepLast100, r.end.worstOverlap(), r.end.ballOverlap,
      r.end.groundOverlap, r.end.wallOverlap, r.start.energy(), r.end.energy(),
      r.start.kineticEnergy, r.end.kineticEnergy, r.end.escaped,
      r.rest ? fmt::format("{:.6g},{:.6g},{:.6g}", r.rest->settledAt(), r.rest->moved(),
                           r.rest->kineticRise())
             : ",,",
      r.asleep, stepColumns(r.shares, r.books), r.memory ? fmt::format("{:.6g}", *r.memory) : "",
      hashText(r.stateHash), buildColumns());
}

}  // namespace wells
