#include "trial_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "engines.h"
#include "flight/integrators.h"
#include "step_work.h"

namespace wells {
namespace {

/// Not vertically: what touches the ground goes on touching it.
void nudgeBalls(Balls& balls, double nudge) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls.position[i].x() += i % 2 == 0 ? nudge : -nudge;
    balls.position[i].z() += i / 2 % 2 == 0 ? nudge : -nudge;
  }
}

}  // namespace

TrialRun Trials::run(const TrialMethod& method, const TrialTimes& times,
                     std::int64_t stepsPerInterval, const TrialStop& stop, double nudge) {
  auto [now, beforeStep] = world_(times.dt(stepsPerInterval));
  now.settings.integrator = method.integrator;
  now.settings.contactMethod = method.contacts;
  now.settings.substeps = method.substeps;
  nudgeBalls(now.balls, nudge);
  const StepShape shape{.balls = now.balls.size(),
                        .wells = now.tracks.size(),
                        .evaluations = findIntegrator(method.integrator).evaluations,
                        .substeps = method.substeps,
                        .iterations = now.settings.iterations};
  const auto stepper = makeEngine("ours");
  TrialRun run;
  for (int sample = 0; sample < times.count; ++sample) {
    for (std::int64_t step = 0; step < stepsPerInterval; ++step) {
      if (beforeStep) beforeStep(now);
      stepper->step(now);
      const StepCounts counts = stepper->counts();
      ++run.steps;
      const double work = stepWork(counts, shape);
      run.work += work;
      work_ += work;
      run.usedSubsteps |= counts.substepBalls > 0;
      if (run.work > stop.work) break;
    }
    run.contacts = contactMethod(stepper->contactMethod()).value_or(method.contacts);
    if (run.work > stop.work) return run;
    run.samples.push_back(now.balls.position);
    if (stop.goesOn && !stop.goesOn(run.samples.back(), sample)) return run;
  }
  return run;
}

double Trials::spent() const {
  const double time = std::chrono::duration<double>(Clock::now() - start_).count();
  return std::max(work_ / kMostTrialWork, time / kMostTrialTime);
}

std::string name(const TrialMethod& method) {
  return fmt::format("{} {}", method.integrator, name(method.contacts));
}

double largestDistance(const Positions& a, const Positions& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!isFinite(a[i]) && !isFinite(b[i])) continue;  // stands still, in any method
    const double distance = length(a[i] - b[i]);
    if (!(distance <= std::numeric_limits<double>::max()))
      return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

}  // namespace wells
