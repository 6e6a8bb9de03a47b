#include "bench_settling.h"

#include <fmt/format.h>

#include <algorithm>

#include "errors.h"
#include "world/measures.h"
#include "world/settling.h"

namespace wells {

void settle(Stepper& stepper, World& world, const std::function<void(std::int64_t)>& progress) {
  Settling settling;
  settling.add(world.time(), kineticEnergy(world.balls));
  const double latest = world.time() + kLongestSettling;
  for (std::int64_t step = 0; !settling.isSettled(); ++step) {
    if (world.time() > latest)
      throw RunError(fmt::format(
          "the world has not settled within {} s: its kinetic energy is {:.3g} J, its peak was "
          "{:.3g} J",
          kLongestSettling, kineticEnergy(world.balls), settling.peak()));
    stepper.step(world);
    settling.add(world.time(), kineticEnergy(world.balls));
    if (step % 16 == 0) progress(step + 1);
  }
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
