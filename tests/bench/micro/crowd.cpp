// A crowd through a step, and its kernels: batches of contacts that share no ball, and passes of
// the solver over them.
#include "world/crowd.h"

#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/micro/worlds.h"
#include "world/candidates.h"
#include "world/islands.h"

namespace wells {
namespace {

/// The largest island of a heap.
struct LargestIsland {
  explicit LargestIsland(const World& world) {
    const StepStart start(world);
    candidates.find(world, start.reach, start.balls);
    islands.find(candidates.ballPairs(), candidates.arenaPairs(), start.balls);
    for (std::size_t n = 1; n < islands.count(); ++n)
      if (islands.balls(n).size() > islands.balls(index).size()) index = n;
  }

  auto balls() const { return islands.balls(index); }
  auto pairs() const { return islands.pairs(index); }

  Candidates candidates;
  Islands islands;
  std::size_t index = 0;
};

void splitIntoBatches(benchmark::State& state) {
  const World& world = heap(static_cast<std::size_t>(state.range(0)));
  const LargestIsland island(world);
  SpatialOrder order;
  order.sort(world.balls, island.balls());
  std::vector<std::uint32_t> place(world.balls.size());
  for (std::uint32_t k = 0; k < order.ids().size(); ++k) place[order.ids()[k]] = k;
  // All as if they were near.
  std::vector<IndexPair> pairs;
  std::vector<BallPair> arena;
  for (const BallPair& pair : island.pairs())
    if (isBall(pair.b))
      pairs.push_back({place[pair.a], place[pair.b]});
    else
      arena.push_back(pair);
  std::ranges::stable_sort(pairs, {}, &IndexPair::a);
  std::vector<std::uint32_t> firstOf;
  for (std::uint32_t k = 0; k <= order.ids().size(); ++k)
    firstOf.push_back(static_cast<std::uint32_t>(
        std::ranges::lower_bound(pairs, k, {}, &IndexPair::a) - pairs.begin()));
  ContactBatches batches;
  ThreadPool pool;
  for (auto _ : state) batches.split({pairs, firstOf}, arena, place, 1, pool);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(island.pairs().size()));
  state.counters["batches"] = static_cast<double>(batches.batches().size());
}
BENCHMARK(splitIntoBatches)->Arg(1000)->Arg(10000);

/// Four substeps with so many passes each: what a pass takes is the difference. Items are pairs
/// that may touch.
void stepCrowd(benchmark::State& state) {
  World world = heap(static_cast<std::size_t>(state.range(0)));
  world.settings.iterations = static_cast<int>(state.range(1));
  const LargestIsland island(world);
  const Model model(world);
  const Balls start = world.balls;
  Crowd crowd;
  const ContactMemory memory;
  ThreadPool pool;
  for (auto _ : state) {
    world.balls = start;
    crowd.step({world.settings, model.path, island.balls(), island.pairs(),
                island.candidates.isLeaning(), memory},
               world.balls, pool, nullptr);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(island.pairs().size()));
}
BENCHMARK(stepCrowd)->ArgNames({"balls", "passes"})->ArgsProduct({{1000, 10000}, {1, 2, 4, 8}});

}  // namespace
}  // namespace wells
