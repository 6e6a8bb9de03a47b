// Contacts of small islands in a substep: sequential impulses and the direct solver.
#include <benchmark/benchmark.h>

#include <vector>

#include "bench/micro/worlds.h"
#include "contacts/direct_solver.h"
#include "contacts/sequential_impulses.h"

namespace wells {
namespace {

constexpr double kSubstep = 1.0 / 240;  // s

/// A chain of balls that lie on the ground and on each other: 2 n - 1 contacts of n balls.
struct Chain {
  explicit Chain(std::size_t count) {
    world.settings.elasticity = 0;
    world.arena.radius = 1000;
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(i);
      world.balls.add({{x, 0.5, 0}, {0, -9.81 * kSubstep, 0}}, 0.5, 1);
    }
    for (std::uint32_t i = 0; i + 1 < count; ++i) ballContacts.push_back({.a = i, .b = i + 1});
    for (std::uint32_t i = 0; i < count; ++i) arenaContacts.push_back({.a = i, .b = kGround});
    velocityBefore.resize(count, Vec3::Zero());
  }

  World world;
  std::vector<Contact> ballContacts;
  std::vector<Contact> arenaContacts;
  std::vector<Vec3> velocityBefore;
};

/// Up to kMostDirect contacts they are solved directly. Items are contacts.
void resolve(benchmark::State& state) {
  Chain chain(static_cast<std::size_t>(state.range(0)));
  ContactWorkspace workspace;
  const Balls start = chain.world.balls;
  for (auto _ : state) {
    chain.world.balls = start;
    benchmark::DoNotOptimize(resolveContacts(chain.world.settings, chain.world.arena, kSubstep,
                                             {chain.ballContacts, chain.arenaContacts},
                                             chain.velocityBefore.data(), chain.world.balls,
                                             workspace));
  }
  const std::size_t contacts = chain.ballContacts.size() + chain.arenaContacts.size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(contacts));
}
BENCHMARK(resolve)->ArgName("balls")->Arg(1)->Arg(4)->Arg(12)->Arg(60);

/// From nothing: no impulses to start from.
void solveDirectly(benchmark::State& state) {
  Chain chain(static_cast<std::size_t>(state.range(0)));
  std::vector<Contact*> contacts;
  for (auto* list : {&chain.ballContacts, &chain.arenaContacts})
    for (Contact& c : *list) {
      touch(chain.world.arena, chain.world.balls, c);
      c.inverseMassA = 1;
      c.inverseMassB = isBall(c.b) ? 1 : 0;
      contacts.push_back(&c);
    }
  DirectSolver solver;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        solver.solve(chain.world.settings.friction, contacts, chain.world.balls));
}
BENCHMARK(solveDirectly)->ArgName("balls")->Arg(1)->Arg(4)->Arg(12);

}  // namespace
}  // namespace wells
