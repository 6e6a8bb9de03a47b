#include "wake_cost.h"

#include <fmt/format.h>

#include <chrono>

#include "bench_row.h"
#include "errors.h"

namespace wells {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kSteps = 60;
constexpr double kSpeed = 5;  // m/s, towards the next ball
constexpr std::size_t kMostShare = 10;

/// Every so many-th ball, so that they are far from each other.
void throwIn(World& world, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t i = (2 * n + 1) * world.balls.size() / (2 * count);
    BallState ball = world.balls.state(i);
    ball.velocity = {kSpeed, 0, 0};
    world.setState(i, ball);
  }
}

}  // namespace

std::vector<WakeRow> wakeCost(Stepper& stepper, const World& asleep) {
  if (!stepper.memory()) throw RunError(fmt::format("engine {} cannot start over", stepper.name()));
  const StepperMemory memory = *stepper.memory();
  std::vector<WakeRow> rows;
  for (std::size_t count = 0; count <= asleep.balls.size() / kMostShare;
       count = count == 0 ? 1 : 10 * count) {
    World world = asleep;
    stepper.restore(memory);
    stepper.step(world);  // builds what is not saved
    throwIn(world, count);
    WakeRow row{.thrown = static_cast<std::int64_t>(count), .steps = kSteps};
    for (std::int64_t step = 0; step < kSteps; ++step) {
      const auto before = Clock::now();
      stepper.step(world);
      row.stepTime += std::chrono::duration<double>(Clock::now() - before).count() / kSteps;
      row.awake += static_cast<double>(static_cast<std::int64_t>(world.balls.size()) -
                                       stepper.counts().asleep) /
                   kSteps;
    }
    rows.push_back(row);
  }
  return rows;
}

std::string wakeText(std::span<const WakeRow> rows) {
  std::string text = fmt::format("{:>12} {:>12} {:>12} {:>18}\n", "thrown in", "awake", "ms a step",
                                 "us a ball awake");
  for (const WakeRow& row : rows)
    text += fmt::format("{:>12} {:>12.1f} {:>12.3g} {:>18}\n", row.thrown, row.awake,
                        1e3 * row.stepTime,
                        row.awake > 0 ? fmt::format("{:.3g}", 1e6 * row.stepTime / row.awake) : "");
  return text;
}

std::string wakeCsv(std::span<const WakeRow> rows) {
  std::string csv = fmt::format("thrown,steps,awake_mean,ms_per_step,{}\n", kBuildColumns);
  for (const WakeRow& row : rows)
    csv += fmt::format("{},{},{:.6g},{:.6g},{}\n", row.thrown, row.steps, row.awake,
                       1e3 * row.stepTime, buildColumns());
  return csv;
}

}  // namespace wells
