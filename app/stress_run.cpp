#include "stress_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "world/measures.h"

namespace wells {
namespace {

using Clock = std::chrono::steady_clock;

/// How far energy was ever above what it had been before.
class EnergyWatch {
 public:
  explicit EnergyWatch(double allowed) : allowed_(allowed) {}

  void see(const Measures& now, StressResult& result) {
    const double energy = now.energy();
    const double above = energy - lowest_ - allowed_;
    const double gain = std::isnan(above) ? std::numeric_limits<double>::infinity() : above;
    lowest_ = std::min(lowest_, energy);
    if (!(gain > 0)) return;
    const double scale = std::max({std::abs(energy), now.kineticEnergy, 1.0});
    result.gain = std::max(result.gain, gain);
    result.relativeGain =
        std::max(result.relativeGain, std::isfinite(scale) ? gain / scale : scale);
  }

 private:
  const double allowed_;  // J
  double lowest_ = std::numeric_limits<double>::infinity();
};

void add(const StepCounts& step, StepCounts& sum) {
  sum.latePairs += step.latePairs;
  sum.exactBalls += step.exactBalls;
  sum.substepBalls += step.substepBalls;
  sum.impacts += step.impacts;
  sum.clusters += step.clusters;
  sum.handedOver += step.handedOver;
  sum.directContacts += step.directContacts;
  sum.unsolvedIslands += step.unsolvedIslands;
}

std::int64_t countNotFinite(const Balls& balls, std::span<const std::uint32_t> among) {
  std::int64_t count = 0;
  for (const std::uint32_t i : among)
    if (!isFinite(balls.state(i))) ++count;
  return count;
}

std::int64_t countLost(const World& world, std::span<const std::uint32_t> among) {
  std::int64_t count = 0;
  for (const std::uint32_t i : among) {
    const Vec3 d = world.balls.position[i] - world.arena.center;
    const double margin = kOutside * world.balls.radius[i];
    if (d.y() < -margin || std::hypot(d.x(), d.z()) > world.arena.radius + margin) ++count;
  }
  return count;
}

World withoutLast(World world, std::size_t count) {
  Balls& balls = world.balls;
  const std::size_t size = balls.size() - count;
  balls.position.resize(size);
  balls.velocity.resize(size);
  balls.spin.resize(size);
  balls.radius.resize(size);
  balls.mass.resize(size);
  return world;
}

/// One version of a case, step by step.
class StressRun {
 public:
  StressRun(const StressCase& stress, StressWorld start, const MakeStepper& makeStepper)
      : stress_(stress),
        start_(std::move(start)),
        world_(start_.world),
        stepper_(makeStepper()),
        good_(world_.balls.size() - start_.bad),
        bad_(start_.bad),
        energy_(start_.pushOut) {
    std::iota(good_.begin(), good_.end(), 0u);
    std::iota(bad_.begin(), bad_.end(), static_cast<std::uint32_t>(good_.size()));
  }

  /// To the end, or until it gives up or `end` has come.
  void run(Clock::time_point end, const StressObserver& observe, StressResult& result) {
    energy_.see(measure(world_, good_), result);
    if (observe) observe(*stepper_, world_);
    for (std::int64_t step = 0; step < stress_.steps; ++step) {
      if (Clock::now() > end) {
        result.isOutOfTime = true;
        return;
      }
      if (!this->step(result)) return;
      judge(result);
      if (observe) observe(*stepper_, world_);
    }
  }

  const World& world() const { return world_; }

 private:
  bool step(StressResult& result) {
    setDt(stress_, start_.world, world_);
    try {
      const auto before = Clock::now();
      stepper_->step(world_);
      result.stepTime += std::chrono::duration<double>(Clock::now() - before).count();
    } catch (const std::exception& error) {
      result.gaveUp.push_back(start_.about.empty()
                                  ? std::string(error.what())
                                  : fmt::format("{}: {}", start_.about, error.what()));
      return false;
    }
    ++result.steps;
    return true;
  }

  void judge(StressResult& result) {
    const Measures now = measure(world_, good_);
    if (stress_.energy != EnergyPromise::WellsMove) energy_.see(now, result);
    result.notFinite = std::max(result.notFinite, countNotFinite(world_.balls, good_));
    add(stepper_->counts(), result.counts);
    result.isNamed = result.isNamed && std::ranges::equal(stepper_->quarantined(), bad_);
    if (world_.step <= stress_.apart) return;
    result.lost = std::max(result.lost, countLost(world_, good_));
    result.overlap = std::max(result.overlap, now.worstOverlap());
  }

  const StressCase& stress_;
  const StressWorld start_;
  World world_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<std::uint32_t> good_;  // balls that start finite
  std::vector<std::uint32_t> bad_;   // the others
  EnergyWatch energy_;
};

}  // namespace

StressResult runStress(const StressCase& stress, const MakeStepper& makeStepper, double mostTime,
                       const std::function<void(World&)>& change, const StressObserver& observe) {
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(mostTime));
  StressResult result;
  for (int version = 0; version < stress.versions && !result.isOutOfTime; ++version) {
    StressWorld start = stress.make(version);
    if (change) change(start.world);
    StressRun run(stress, start, makeStepper);
    run.run(end, observe, result);
    if (start.bad > 0) {
      const World without = withoutLast(start.world, start.bad);
      StressRun twin(stress, {.about = {}, .world = without}, makeStepper);
      StressResult ofTwin;
      twin.run(end, {}, ofTwin);
      if (stateHash(withoutLast(run.world(), start.bad)) != stateHash(twin.world()))
        result.isInfected = true;
    }
    if (result.firstBroken.empty() && verdict(stress, result) != "held")
      result.firstBroken = start.about;
  }
  return result;
}

std::string verdict(const StressCase& stress, const StressResult& result) {
  const double mostGain = stress.energy == EnergyPromise::NeverRises ? kRoundingGain : kPressedGain;
  std::vector<std::string> broken;
  if (!result.gaveUp.empty()) broken.emplace_back("gave up");
  if (result.isOutOfTime) broken.emplace_back("out of time");
  if (result.notFinite > 0) broken.emplace_back("not finite");
  if (result.lost > 0) broken.emplace_back("lost balls");
  if (result.relativeGain > mostGain) broken.emplace_back("gained energy");
  if (result.isInfected) broken.emplace_back("infected");
  return broken.empty() ? "held" : fmt::format("{}", fmt::join(broken, ", "));
}

}  // namespace wells
