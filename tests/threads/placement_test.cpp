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
      ASSERT_TRUE(pinThisThread({&core, 1}));
      EXPECT_EQ(allowedCores(), std::vector{core});
      EXPECT_EQ(::sched_getcpu(), core);
      ThreadPool pool(3);
      pool.run([&](int, Barrier&) { EXPECT_EQ(allowedCores(), std::vector{core}); });
      EXPECT_TRUE(pinThisThread(cores));
      EXPECT_EQ(allowedCores(), cores);
    }).join();
  }
  EXPECT_EQ(allowedCores(), cores) << "of the thread that started them";
}

TEST(Placement, DoesNotPinToCoresThatAreNotThere) {
  const std::vector<int> cores = allowedCores();
  for (const int core : {-1, 1 << 20, CPU_SETSIZE - 1})
    EXPECT_FALSE(pinThisThread({&core, 1})) << core << ": a machine of 1024 processors?";
  EXPECT_FALSE(pinThisThread({})) << "nowhere";
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

TEST(Placement, WorkersAreNamed) {
  const std::string before = nameOfThisThread();
  ThreadPool pool(3);
  pool.run([&](int thread, Barrier&) {
    EXPECT_EQ(nameOfThisThread(),
              thread == 0 ? before : "simulation " + std::to_string(thread + 1));
  });
}

}  // namespace
}  // namespace wells
