// A warm step takes no memory from the heap. An executable of its own: it replaces operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "scenes/catalogue.h"
#include "world/simulation.h"

namespace {
std::atomic<long> allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace wells {
namespace {

/// By 100 steps of a scene after the first `warm`.
long allocationsOf(const char* scene, std::size_t balls, int warm) {
  World world = makeScene(findScene(scene), balls);
  const auto simulation = makeSimulation();
  for (int step = 0; step < warm; ++step) simulation->step(world);
  const long before = allocations;
  for (int step = 0; step < 100; ++step) simulation->step(world);
  return allocations - before;
}

// Lists keep what they took, so a step takes something only where more balls than ever before meet:
// a heap still grows while it collapses, a gas has its largest groups after a while.
TEST(Allocation, WarmStepTakesNothingFromTheHeap) {
  EXPECT_EQ(allocationsOf("T1", 25, 300), 0);
  EXPECT_EQ(allocationsOf("T1", 1000, 300), 0);
  EXPECT_EQ(allocationsOf("T2", 1000, 300), 0);
}

TEST(Allocation, NorDoesOneOnSeveralThreads) {
  World world = makeScene(findScene("T1"), 500);
  const auto simulation = makeSimulation({.threads = 3, .leastBallsForThreads = 0});
  for (int step = 0; step < 400; ++step) simulation->step(world);
  ASSERT_EQ(simulation->counts().threads, 3);
  const long before = allocations;
  for (int step = 0; step < 100; ++step) simulation->step(world);
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, NorDoesOneAtAWorldThatSleeps) {
  World world = makeScene(findScene("T3"), 500);
  const auto simulation = makeSimulation();
  for (int step = 0; step < 60; ++step) simulation->step(world);
  ASSERT_EQ(simulation->counts().asleep, 500);
  const long before = allocations;
  for (int step = 0; step < 100; ++step) simulation->step(world);
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace wells
