#include "accuracy_run.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "engines.h"
#include "errors.h"
#include "flight/integrators.h"
#include "scenes/catalogue.h"
#include "world/measures.h"

namespace wells {
namespace {

// Runs too short for the clock are timed by so many at once. More would push each other's memory
// out of the cache.
constexpr std::size_t kTimedTogether = 8;

/// s of this process, all threads.
double cpuTime() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One step size of one method of one case.
struct Task {
  const AccuracyCase& answer;
  const Scene& scene;
  const Method& method;
  std::int64_t steps;

  double dt() const { return answer.duration / static_cast<double>(steps); }

  World world() const {
    World start = makeScene(scene);
    start.settings.dt = dt();
    if (method.engine != "ours") return start;
    start.settings.integrator = method.integrator;
    start.settings.contactMethod = *contactMethod(method.contacts);
    return start;
  }

  std::unique_ptr<Stepper> stepper() const {
    return makeEngine(method.engine, scene.sleeping ? Sleeping::On : Sleeping::Off);
  }
};

/// An engine that has taken the first step, in which it builds what it keeps (Bullet its world).
struct WarmRun {
  World world;
  std::unique_ptr<Stepper> stepper;

  explicit WarmRun(const Task& task) : world(task.world()), stepper(task.stepper()) {
    stepper->step(world);
  }
};

bool conservesEnergy(const World& world) {
  return world.settings.elasticity == 1 && world.settings.friction == 0 && world.settings.drag == 1;
}

WorkPoint measureErrors(const Task& task) {
  World world = task.world();
  const Measures start = measure(world);
  const auto stepper = task.stepper();
  for (std::int64_t step = 0; step < task.steps; ++step) stepper->step(world);
  const Measures end = measure(world);

  WorkPoint point{.dt = task.dt(), .steps = task.steps};
  point.error = positionError(task.answer, world);
  point.energyError = conservesEnergy(world)
                          ? std::abs(end.energy() - start.energy()) /
                                (std::abs(start.kineticEnergy) + std::abs(start.potentialEnergy))
                          : std::numeric_limits<double>::quiet_NaN();
  point.escaped = end.escaped;
  point.stateHash = stateHash(world);
  return point;
}

/// CPU time (s) of all steps. The first is not timed but counted like the others.
double timeOnce(const Task& task, const LadderLimits& limits, double expected, std::uint64_t hash) {
  const std::size_t together = expected < limits.shortestTiming ? kTimedTogether : 1;
  double time = 0;
  std::int64_t timedSteps = 0;
  while (time < limits.shortestTiming || timedSteps == 0) {
    std::vector<WarmRun> runs;
    for (std::size_t run = 0; run < together; ++run) runs.emplace_back(task);
    const double start = cpuTime();
    for (WarmRun& run : runs)
      for (std::int64_t step = 1; step < task.steps; ++step) run.stepper->step(run.world);
    time += cpuTime() - start;
    timedSteps += static_cast<std::int64_t>(together) * (task.steps - 1);
    if (stateHash(runs.back().world) != hash)
      throw RunError(fmt::format("{}, {}, dt = {} s: two runs end with different bits",
                                 task.answer.scene, name(task.method), task.dt()));
  }
  return time / static_cast<double>(timedSteps) * static_cast<double>(task.steps);
}

WorkPoint run(const Task& task, const LadderLimits& limits) {
  const double start = cpuTime();
  WorkPoint point = measureErrors(task);
  const double expected = cpuTime() - start;
  std::vector<double> times;
  for (std::int64_t repeat = 0; repeat < limits.repeats; ++repeat)
    times.push_back(timeOnce(task, limits, expected, point.stateHash));
  point.cpu = median(times);
  point.repeats = limits.repeats;
  return point;
}

}  // namespace

Method defaultMethod() {
  const Settings settings;
  return {"ours", settings.integrator, std::string(name(settings.contactMethod))};
}

std::vector<Method> methodsOf(std::string_view engine) {
  if (engine != "ours") return {{std::string(engine), "", ""}};
  std::vector<Method> methods;
  for (const ContactMethod contacts : {ContactMethod::Substep, ContactMethod::Exact})
    for (const Integrator& integrator : integrators())
      methods.push_back({"ours", std::string(integrator.name), std::string(name(contacts))});
  const auto standard = std::find(methods.begin(), methods.end(), defaultMethod());
  if (standard == methods.end()) methods.push_back(defaultMethod());
  return methods;
}

Ladder runLadder(const AccuracyCase& answer, const Method& method, const LadderLimits& limits,
                 const std::function<void(double)>& progress) {
  Ladder ladder{method, {}, {}};
  if (method.engine != "ours") {
    const auto stepper = makeEngine(method.engine);
    ladder.method = {method.engine, stepper->integrator(), stepper->contactMethod()};
  }
  double timeOfStep = 0;  // s, with the last step size
  for (const std::int64_t steps : stepLadder(answer.duration, limits.coarsestStep, limits.rungs)) {
    const Task task{answer, findScene(answer.scene), method, steps};
    const double expected = timeOfStep * static_cast<double>(steps);
    if (expected > limits.longestRun) {
      ladder.notes.push_back(
          fmt::format("dt = {:.3g} s and below: not run, {} steps would take "
                      "{:.2g} s, and {} s is the most",
                      task.dt(), steps, expected, limits.longestRun));
      break;
    }
    progress(task.dt());
    const double start = cpuTime();
    try {
      ladder.points.push_back(run(task, limits));
      timeOfStep = ladder.points.back().cpu / static_cast<double>(steps);
    } catch (const RunError&) {
      throw;
    } catch (const std::runtime_error& error) {
      ladder.notes.push_back(fmt::format("dt = {:.3g} s: given up: {}", task.dt(), error.what()));
      timeOfStep = (cpuTime() - start) / static_cast<double>(steps);
    }
    if (isAtRounding(ladder.points)) {
      ladder.notes.push_back(
          fmt::format("below dt = {:.3g} s: not run, the error is at rounding already", task.dt()));
      break;
    }
  }
  return ladder;
}

}  // namespace wells
