#include "accuracy_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "accuracy_task.h"
#include "accuracy_timing.h"
#include "case_error.h"
#include "engines.h"
#include "errors.h"
#include "flight/integrators.h"
#include "world/measures.h"

namespace wells {
namespace {

bool conservesEnergy(const World& world) {
  const Settings& settings = world.settings;
  return settings.elasticity == 1 && settings.friction == 0 && settings.rollingResistance == 0 &&
         settings.drag == 1;
}

WorkPoint measureErrors(const AccuracyTask& task) {
  World world = task.world();
  const Measures start = measure(world);
  const auto stepper = task.stepper();
  const bool hasBooks = task.steps <= kMostBookedSteps && stepper->openBooks();
  WorkPoint point;
  point.dt = task.dt();
  point.steps = task.steps;
  CaseError error(task.answer, world);
  for (std::int64_t step = 0; step < task.steps; ++step) {
    error.beginStep(world);
    stepper->step(world);
    point.shares.add(stepper->counts(), world.balls.size());
  }
  if (hasBooks) point.books = *stepper->books();
  const Measures end = measure(world);
  point.error = error.atTheEnd(world);
  point.energyError = conservesEnergy(world)
                          ? std::abs(end.energy() - start.energy()) /
                                (std::abs(start.kineticEnergy) + std::abs(start.potentialEnergy))
                          : std::numeric_limits<double>::quiet_NaN();
  point.escaped = end.escaped;
  point.stateHash = stateHash(world);
  return point;
}

WorkPoint run(const AccuracyTask& task, const LadderLimits& limits) {
  const double start = cpuTime();
  WorkPoint point = measureErrors(task);
  StepTiming timing(task, limits.shortestTiming, cpuTime() - start, point.stateHash);
  std::vector<double> times;
  for (std::int64_t repeat = 0; repeat < limits.repeats; ++repeat)
    times.push_back(timing.measure());
  point.cpu = median(times);
  point.repeats = limits.repeats;
  return point;
}

std::vector<std::int64_t> stepCounts(double duration, const LadderLimits& limits) {
  if (limits.stepSizes.empty()) return stepLadder(duration, limits.coarsestStep, limits.rungs);
  std::vector<std::int64_t> counts;
  for (const double dt : limits.stepSizes)
    counts.push_back(std::max<std::int64_t>(2, std::llround(duration / dt)));
  return counts;
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
  for (const std::int64_t steps : stepCounts(answer.duration, limits)) {
    const AccuracyTask task{answer, findScene(answer.scene), method, steps};
    const double expected = timeOfStep * static_cast<double>(steps);
    if (limits.stepSizes.empty() && expected > limits.longestRun) {
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
    if (limits.stepSizes.empty() && isAtRounding(ladder.points)) {
      ladder.notes.push_back(
          fmt::format("below dt = {:.3g} s: not run, the error is at rounding already", task.dt()));
      break;
    }
  }
  return ladder;
}

}  // namespace wells
