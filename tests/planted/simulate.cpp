#include <algorithm>

#include "planted/catching.h"
#include "planted/choice.h"
#include "simulation/draw_schedule.h"
#include "simulation/simulator.h"

namespace wells::planted {
namespace {

using simulation::Fault;
using simulation::FaultKind;

std::vector<FaultKind> kindsOf(std::string_view names) {
  std::vector<FaultKind> kinds;
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(", "));
    const auto place = std::ranges::find(simulation::kFaultNames, name);
    if (place == simulation::kFaultNames.end())
      throw std::runtime_error("defects.txt: there is no fault " + std::string(name));
    kinds.push_back(static_cast<FaultKind>(place - simulation::kFaultNames.begin()));
    names.remove_prefix(std::min(names.size(), name.size() + 2));
  }
  return kinds;
}

double amountOf(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::Loss:
      return 0.3;
    case FaultKind::Delay:
      return 0.15;  // s
    case FaultKind::TinyBuffer:
      return 3;
    case FaultKind::ReplayLog:
      return 2 + fault.duration;  // s ago
    default:
      return fault.amount;
  }
}

/// Turns what goes wrong after the start into faults of these kinds.
void draw(const std::vector<FaultKind>& kinds, simulation::Schedule& schedule) {
  if (kinds.empty()) return;
  std::size_t next = 0;
  for (Fault& fault : schedule.faults) {
    if (fault.kind == FaultKind::Start || fault.at == 0) continue;
    fault.kind = kinds[next++ % kinds.size()];
    fault.amount = amountOf(fault);
  }
}

}  // namespace

std::optional<Catch> simulate(const Defect& defect, std::uint64_t seed, Planting planting) {
  auto schedule = simulation::drawSchedule(seed, {});
  draw(kindsOf(defect.faults), schedule);
  choice = planting == Planting::On ? defect.number : 0;
  const auto outcome = simulation::simulate(schedule);
  choice = 0;
  if (outcome.violations.empty()) return std::nullopt;
  const simulation::Violation& first = outcome.violations.front();
  return Catch{std::string(name(first.invariant)), first.what};
}

}  // namespace wells::planted
