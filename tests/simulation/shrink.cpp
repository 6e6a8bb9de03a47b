#include "simulation/shrink.h"

#include <algorithm>
#include <functional>

namespace wells::simulation {
namespace {

class Shrinker {
 public:
  Shrinker(const Schedule& failing, Invariant invariant, int mostRuns)
      : best_(failing), invariant_(invariant), runsLeft_(mostRuns) {}

  Schedule shrunk() {
    for (bool isBetter = true; isBetter && runsLeft_ > 0;) {
      const Schedule before = best_;
      dropFaults();
      simplifyGroup();
      for (std::size_t i = 0; i < best_.faults.size(); ++i) weaken(i);
      isBetter = before != best_;
    }
    return best_;
  }

 private:
  /// Keeps `simpler` if it still fails.
  bool attempt(const Schedule& simpler) {
    if (simpler == best_ || runsLeft_ == 0) return false;
    --runsLeft_;
    const Outcome outcome = simulate(simpler);
    const bool fails =
        !outcome.violations.empty() && outcome.violations.front().invariant == invariant_;
    if (fails) best_ = simpler;
    return fails;
  }

  bool attempt(const std::function<void(Schedule&)>& change) {
    Schedule simpler = best_;
    change(simpler);
    return attempt(simpler);
  }

  void dropFaults() {
    for (std::size_t size = std::max<std::size_t>(best_.faults.size() / 2, 1);; size /= 2) {
      for (std::size_t first = 0; first < best_.faults.size();) {
        const bool isDropped = attempt([&](Schedule& schedule) {
          const auto begin = schedule.faults.begin() + static_cast<std::ptrdiff_t>(first);
          const auto count = std::min(size, schedule.faults.size() - first);
          schedule.faults.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
        });
        if (!isDropped) first += size;
      }
      if (size <= 1) return;
    }
  }

  void simplifyGroup() {
    for (const int balls : {1, 2, 4})
      if (balls < best_.balls && attempt([&](Schedule& schedule) { schedule.balls = balls; }))
        break;
    attempt([](Schedule& schedule) { schedule.latency = 0; });
  }

  void weaken(std::size_t i) {
    const auto change = [&](const std::function<void(Fault&)>& edit) {
      return attempt([&](Schedule& schedule) { edit(schedule.faults[i]); });
    };
    change([](Fault& fault) { fault.amount = 0; });
    while (change([](Fault& fault) { fault.amount = coarser(fault.amount / 2); })) continue;
    while (change([](Fault& fault) { fault.duration = coarser(fault.duration / 2); })) continue;
    change([](Fault& fault) { fault.state.reset(); });
  }

  /// So that halving comes to an end.
  static double coarser(double value) {
    return static_cast<double>(static_cast<std::int64_t>(value * 100)) / 100;
  }

  Schedule best_;
  Invariant invariant_;
  int runsLeft_;
};

}  // namespace

Schedule shrink(const Schedule& failing, Invariant invariant, int mostRuns) {
  return Shrinker(failing, invariant, mostRuns).shrunk();
}

}  // namespace wells::simulation
