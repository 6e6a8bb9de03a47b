#include "simulation/fault.h"

#include <fmt/format.h>

namespace wells::simulation {

std::string describe(const Fault& fault) {
  std::string text = fmt::format("{:7.3f} s  {}", fault.at, name(fault.kind));
  text += fault.slot == Fault::kAnySlot ? ", any peer" : fmt::format(", slot {}", fault.slot);
  if (fault.kind == FaultKind::CutLink) text += fmt::format(" to slot {}", fault.other);
  if (fault.state) text += fmt::format(", when {}", name(*fault.state));
  if (fault.amount != 0) text += fmt::format(", amount {:.3f}", fault.amount);
  if (fault.duration != 0) text += fmt::format(", for {:.3f} s", fault.duration);
  return text;
}

std::string describe(const Schedule& schedule) {
  std::string text = fmt::format(
      "seed {}: {} peers, {} balls, latency {:.4f} s, healing at {:.1f} s, stop at {:.1f} s, end "
      "at "
      "{:.1f} s\n",
      schedule.seed, schedule.peers, schedule.balls, schedule.latency, schedule.heal, schedule.stop,
      schedule.end);
  for (const Fault& fault : schedule.faults) text += "  " + describe(fault) + "\n";
  return text;
}

}  // namespace wells::simulation
