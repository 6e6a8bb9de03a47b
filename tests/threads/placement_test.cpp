// The system is asked where threads run and what they are called.
#include "threads/placement.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <array>
#include <thread>

#include "threads/thread_pool.h"

namespace wells {
namespace {

std::string nameOfThisThread() {
  std::array<char, 16> name{};
  ::pthread_getname_np(::pthread_self(), name.data(), name.size());
  return name.data();
}

TEST(Placement, PinsAThreadAndThoseThatItStarts) {
  const std::vector<int> cores = allowedCores();
  ASSERT_FALSE(cores.empty());
  for (const int core : cores) {
    std::thread([&] {
      ASSERT_TRUE(pinThisThread(core));
      EXPECT_EQ(allowedCores(), std::vector{core});
      EXPECT_EQ(::sched_getcpu(), core);
      std::thread([&] { EXPECT_EQ(allowedCores(), std::vector{core}); }).join();
    }).join();
  }
  EXPECT_EQ(allowedCores(), cores) << "of the thread that started them";
}

TEST(Placement, DoesNotPinToCoresThatAreNotThere) {
  const std::vector<int> cores = allowedCores();
  EXPECT_FALSE(pinThisThread(-1));
  EXPECT_FALSE(pinThisThread(1 << 20));
  EXPECT_FALSE(pinThisThread(CPU_SETSIZE - 1)) << "a machine of 1024 processors?";
  EXPECT_EQ(allowedCores(), cores);
}

TEST(Placement, NamesAThread) {
  std::thread([] {
    nameThisThread("simulation");
    EXPECT_EQ(nameOfThisThread(), "simulation");
    nameThisThread("longer than the system takes");
    EXPECT_EQ(nameOfThisThread(), "longer than the");
  }).join();
}

TEST(Placement, WorkersAreNamedAndTakeTheirCoresInTurn) {
  const int last = allowedCores().back();
  ThreadPool pool({.threads = 3, .cores = {last}});
  pool.run([&](int thread, Barrier&) {
    if (thread == 0) return;
    EXPECT_EQ(allowedCores(), std::vector{last});
    EXPECT_EQ(nameOfThisThread(), "simulation " + std::to_string(thread + 1));
  });
}

}  // namespace
}  // namespace wells
