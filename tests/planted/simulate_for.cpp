#include "planted/catching.h"
#include "planted/choice.h"
#include "simulation/draw_schedule.h"
#include "simulation/simulator.h"

namespace wells::planted {

std::optional<Catch> simulateSeed(int number, std::uint64_t seed) {
  choice = number;
  const auto outcome = simulation::simulate(simulation::drawSchedule(seed, {}));
  choice = 0;
  if (outcome.violations.empty()) return std::nullopt;
  return Catch{std::string(name(outcome.violations.front().invariant)), seed};
}

}  // namespace wells::planted
