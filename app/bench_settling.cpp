#include "bench_settling.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "errors.h"
#include "world/measures.h"
#include "world/settling.h"

namespace wells {
namespace {

/// Steps `world` until isThere() says so, after each step.
template <class IsThere>
void stepUntil(IsThere isThere, std::string_view what, Stepper& stepper, World& world,
               const std::function<void(std::int64_t)>& progress) {
  const double latest = world.time() + kLongestSettling;
  for (std::int64_t step = 0; !isThere(); ++step) {
    if (world.time() > latest)
      throw RunError(fmt::format("the world {} within {} s: its kinetic energy is {:.3g} J", what,
                                 kLongestSettling, kineticEnergy(world.balls)));
    stepper.step(world);
    if (step % 16 == 0) progress(step + 1);
  }
}

}  // namespace

void settle(Stepper& stepper, World& world, const std::function<void(std::int64_t)>& progress) {
  Settling settling;
  const auto isSettled = [&] {
    settling.add(world.time(), kineticEnergy(world.balls));
    return settling.isSettled();
  };
  stepUntil(isSettled, "has not settled", stepper, world, progress);
}

void fallAsleep(Stepper& stepper, World& world, const std::function<void(std::int64_t)>& progress) {
  const auto isAsleep = [&] {
    return stepper.counts().asleep == static_cast<std::int64_t>(world.balls.size());
  };
  stepUntil(isAsleep, "has not fallen asleep", stepper, world, progress);
}

RestWatch::RestWatch(const World& settled)
    : settledAt_(settled.time()),
      start_(settled.balls.position),
      leastEnergy_(kineticEnergy(settled.balls)) {}

void RestWatch::add(const World& world) {
  for (std::size_t i = 0; i < start_.size(); ++i)
    moved_ = std::max(moved_, length(world.balls.position[i] - start_[i]));
  const double energy = kineticEnergy(world.balls);
  rise_ = std::max(rise_, energy - leastEnergy_);
  leastEnergy_ = std::min(leastEnergy_, energy);
}

}  // namespace wells
