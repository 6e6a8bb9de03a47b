#include "planted/catching.h"
#include "planted/choice.h"
#include "simulation/draw_schedule.h"
#include "simulation/simulator.h"

namespace wells::planted {

std::optional<Catch> simulate(int defect, std::uint64_t seed) {
  choice = defect;
  const auto outcome = simulation::simulate(simulation::drawSchedule(seed, {}));
  choice = kNone;
  if (outcome.violations.empty()) return std::nullopt;
  const simulation::Violation& first = outcome.violations.front();
  return Catch{std::string(name(first.invariant)), first.what};
}

}  // namespace wells::planted
