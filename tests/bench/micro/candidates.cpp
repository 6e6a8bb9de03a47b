// Who may touch whom: candidate pairs with their exact gaps, and islands.
#include "world/candidates.h"

#include <benchmark/benchmark.h>

#include "bench/micro/worlds.h"
#include "world/islands.h"

namespace wells {
namespace {

using MakeWorld = const World& (*)(std::size_t);

/// To and fro between a world and what it is a step later. Items are balls.
void findCandidates(benchmark::State& state, MakeWorld make) {
  const World& before = make(static_cast<std::size_t>(state.range(0)));
  const World worlds[] = {before, afterStep(before)};
  const StepStart starts[] = {StepStart(worlds[0]), StepStart(worlds[1])};
  Candidates candidates;
  for (std::size_t n = 0; auto _ : state) {
    candidates.find(worlds[n % 2], starts[n % 2].reach, starts[n % 2].balls);
    ++n;
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(findCandidates, heap, heap)->Arg(25)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(findCandidates, gas, gas)->Arg(10000);

void findIslands(benchmark::State& state, MakeWorld make) {
  const World& world = make(static_cast<std::size_t>(state.range(0)));
  const StepStart start(world);
  Candidates candidates;
  candidates.find(world, start.reach, start.balls);
  Islands islands;
  for (auto _ : state) islands.find(candidates.ballPairs(), candidates.arenaPairs(), start.balls);
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["islands"] = static_cast<double>(islands.count());
}
BENCHMARK_CAPTURE(findIslands, heap, heap)->Arg(25)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(findIslands, gas, gas)->Arg(10000);

}  // namespace
}  // namespace wells
