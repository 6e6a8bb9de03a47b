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

TEST(Allocation, WarmStepTakesNothingFromTheHeap) {
  World world = makeScene(findScene("T1"), 500);
  const auto simulation = makeSimulation();
  // The heap of balls still grows while it collapses, and vectors with it: warm is when it lies.
  for (int step = 0; step < 400; ++step) simulation->step(world);
  const long before = allocations;
  for (int step = 0; step < 100; ++step) simulation->step(world);
  EXPECT_EQ(allocations - before, 0);
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
