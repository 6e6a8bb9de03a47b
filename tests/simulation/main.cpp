#include <cstdio>
#include <cstdlib>
#include "simulation/draw_schedule.h"
#include "simulation/simulator.h"
using namespace wells::simulation;
int main(int argc, char** argv) {
  const auto first = std::strtoull(argv[1], nullptr, 10),
             n = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  Tally t;
  int bad = 0;
  for (auto s = first; s < first + n; ++s) {
    auto o = simulate(drawSchedule(s, {}),
                      n == 1 ? Trace::Keeping::Everything : Trace::Keeping::Nothing);
    t += o.tally;
    if (n == 1) {
      fmt::print("{}{}", describe(drawSchedule(s, {})), o.trace);
    }
    if (!o.violations.empty()) {
      ++bad;
      fmt::print("seed {} {} at {}: {}\n", s, name(o.violations[0].invariant), o.violations[0].time,
                 o.violations[0].what);
    }
  }
  fmt::print(
      "runs {} bad {} seconds {} msgs {} handovers {} least {} adoptions {} fences {} resyncs {} "
      "doubled {} checks {} unsettled {}\n",
      t.runs, bad, t.seconds, t.messagesSent, t.handovers, t.leastHandovers, t.adoptions, t.fences,
      t.resyncs, t.doubledBallSeconds, t.groupChecks, t.unsettled);
}
