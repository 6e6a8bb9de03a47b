// The same bits for any number of threads, on each instruction set of this processor.
#include <gtest/gtest.h>

#include <vector>

#include "math/hash.h"
#include "math/instruction_set.h"
#include "scenes/catalogue.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr std::size_t kForced = 0;  // balls are enough for several threads

enum class Keeping { NoBooks, Books };

/// Of each step.
std::vector<std::uint64_t> hashesOf(World world, int threads, int steps, Keeping keeping) {
  const auto simulation = makeSimulation({.threads = threads, .leastBallsForThreads = kForced});
  if (keeping == Keeping::Books) simulation->openBooks();
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < steps; ++step) {
    simulation->step(world);
    EXPECT_EQ(simulation->counts().threads, threads);
    hashes.push_back(stateHash(world));
  }
  if (const Books* books = simulation->books()) {
    Hash hash;
    for (const double energy : {books->contacts, books->friction, books->drag, books->wells,
                                books->pushOut, books->flight, books->sleep, books->outside})
      hash.add(energy);
    hashes.push_back(hash.value());
  }
  return hashes;
}

void expectSameBits(const World& world, int steps, Keeping keeping = Keeping::NoBooks) {
  const InstructionSet best = instructionSet();
  const auto alone = hashesOf(world, 1, steps, keeping);
  for (const InstructionSet set : instructionSets()) {
    useInstructionSet(set);
    for (const int threads : {1, 2, 4})
      EXPECT_EQ(hashesOf(world, threads, steps, keeping), alone)
          << threads << " threads, " << name(set);
  }
  useInstructionSet(best);
}

class Methods : public testing::TestWithParam<ContactMethod> {};

INSTANTIATE_TEST_SUITE_P(Threads, Methods,
                         testing::Values(ContactMethod::Substep, ContactMethod::Exact,
                                         ContactMethod::Auto),
                         [](const auto& method) { return std::string(name(method.param)); });

TEST_P(Methods, GiveTheSameBitsInAHeap) {
  World world = makeScene(findScene("T1"), 1500);
  world.settings.contactMethod = GetParam();
  expectSameBits(world, GetParam() == ContactMethod::Exact ? 10 : 60);
}

TEST_P(Methods, GiveTheSameBitsInAGas) {
  World world = makeScene(findScene("T2"), 2000);
  world.settings.contactMethod = GetParam();
  expectSameBits(world, 20);
}

TEST(Threads, KeepTheSameBooks) {
  expectSameBits(makeScene(findScene("T1"), 1000), 30, Keeping::Books);
}

TEST(Threads, GiveTheSameBitsWhileBallsFallAsleepAndWake) {
  World world = makeScene(findScene("T3"), 1000);
  // One rolls in when the others sleep.
  const Arena& arena = world.arena;
  const double radius = world.balls.radius[0];
  world.balls.add({.position = arena.center + Vec3{0, 8, 0}}, radius, world.balls.mass[0]);
  expectSameBits(world, 120);
}

TEST(Threads, AreUsedFromTheThresholdOn) {
  World world = makeScene(findScene("T3"), 20);
  const auto threadsOfAStep = [&](std::size_t least) {
    World copy = world;
    const auto simulation = makeSimulation({.threads = 3, .leastBallsForThreads = least});
    simulation->step(copy);
    return simulation->counts().threads;
  };
  EXPECT_EQ(threadsOfAStep(20), 3);
  EXPECT_EQ(threadsOfAStep(21), 1);
}

TEST(Threads, AreNotUsedForThoseWhoSleep) {
  World world = makeScene(findScene("T3"), 20);
  const auto simulation = makeSimulation({.threads = 3, .leastBallsForThreads = 20});
  for (int step = 0; step < 60; ++step) simulation->step(world);
  ASSERT_EQ(simulation->counts().asleep, 20);
  simulation->step(world);
  EXPECT_EQ(simulation->counts().threads, 1);
}

}  // namespace
}  // namespace wells
