// Each thread does its part, once, and sees what the others did before.
#include "threads/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace wells {
namespace {

using namespace std::chrono_literals;

class Pools : public testing::TestWithParam<int> {
 protected:
  ThreadPool pool{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Of, Pools, testing::Values(1, 2, 3, 4, 13),
                         testing::PrintToStringParamName());

TEST(Parts, AreAllThereIsOnceInOrderAndBeginAtGrains) {
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 64u, 1000u, 1001u})
    for (const std::size_t grain : {1u, 3u, 8u, 2000u})
      for (const std::size_t parts : {1u, 2u, 3u, 64u}) {
        std::size_t next = 0;
        std::size_t shortest = count, longest = 0;
        for (std::size_t part = 0; part < parts; ++part) {
          const IndexRange range = partOf(count, grain, part, parts);
          ASSERT_EQ(range.begin, next);
          ASSERT_GE(range.end, range.begin);
          ASSERT_TRUE(range.begin == count || range.begin % grain == 0);
          next = range.end;
          shortest = std::min(shortest, range.end - range.begin);
          longest = std::max(longest, range.end - range.begin);
        }
        ASSERT_EQ(next, count);
        EXPECT_LT(longest - shortest, 2 * grain) << count << " " << grain << " " << parts;
      }
}

TEST_P(Pools, RunEachThreadOnce) {
  for (int call = 0; call < 300; ++call) {
    std::vector<int> calls(static_cast<std::size_t>(pool.threads()));
    std::vector<std::thread::id> ids(calls.size());
    pool.run([&](int thread, Barrier&) {
      ++calls[static_cast<std::size_t>(thread)];
      ids[static_cast<std::size_t>(thread)] = std::this_thread::get_id();
    });
    EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
    EXPECT_EQ(ids[0], std::this_thread::get_id());
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  }
}

TEST_P(Pools, DivideACountIntoRanges) {
  constexpr std::size_t kGrain = 8;
  for (const std::size_t count : {0u, 1u, 8u, 15u, 16u, 17u, 100u, 1003u}) {
    const std::size_t ranges = pool.ranges(count, kGrain);
    EXPECT_LE(ranges, static_cast<std::size_t>(pool.threads()));
    EXPECT_LE((ranges - 1) * kGrain, count);
    std::vector<int> visits(count);
    std::vector<IndexRange> found(ranges);
    pool.forRanges(count, kGrain, [&](std::size_t begin, std::size_t end, std::size_t range) {
      found.at(range) = {begin, end};
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
    for (std::size_t r = 0; r < ranges; ++r) {
      EXPECT_EQ(found[r].begin, r == 0 ? 0 : found[r - 1].end);
      EXPECT_EQ(found[r].begin % kGrain, 0u);
    }
  }
}

TEST_P(Pools, KeepRangesThatAreTooShortInTheCaller) {
  int calls = 0;
  pool.forRanges(15, 8, [&](std::size_t begin, std::size_t end, std::size_t range) {
    ++calls;
    EXPECT_EQ(begin, 0u);
    EXPECT_EQ(end, 15u);
    EXPECT_EQ(range, 0u);
  });
  EXPECT_EQ(calls, 1);
}

// A prefix sum by doubling: in each phase every thread reads what all others wrote in the last one.
TEST_P(Pools, WaitForEachOtherAtTheBarrier) {
  constexpr std::size_t kCount = 1 << 10;
  std::vector<std::uint64_t> from(kCount, 1), to(kCount);
  const auto parts = static_cast<std::size_t>(pool.threads());
  pool.run([&](int thread, Barrier& barrier) {
    const IndexRange mine = partOf(kCount, 1, static_cast<std::size_t>(thread), parts);
    for (std::size_t distance = 1; distance < kCount; distance *= 2) {
      for (std::size_t i = mine.begin; i < mine.end; ++i)
        to[i] = from[i] + (i >= distance ? from[i - distance] : 0);
      barrier.wait();
      if (thread == 0) from.swap(to);
      barrier.wait();
    }
  });
  std::vector<std::uint64_t> expected(kCount);
  std::iota(expected.begin(), expected.end(), 1);
  EXPECT_EQ(from, expected);
}

TEST_P(Pools, PassManyBarriersEvenWhenAThreadIsLate) {
  constexpr int kPhases = 2000;
  std::vector<int> phase(static_cast<std::size_t>(pool.threads()));
  pool.run([&](int thread, Barrier& barrier) {
    for (int p = 0; p < kPhases; ++p) {
      if (p % 500 == 0 && thread == p / 500) std::this_thread::sleep_for(2ms);
      phase[static_cast<std::size_t>(thread)] = p;
      barrier.wait();
      for (const int other : phase) ASSERT_EQ(other, p);
      barrier.wait();
    }
  });
}

TEST_P(Pools, WorkAfterASleep) {
  for (int i = 0; i < 5; ++i) {
    std::this_thread::sleep_for(3ms);
    std::atomic<int> calls = 0;
    pool.run([&](int, Barrier&) { ++calls; });
    EXPECT_EQ(calls, pool.threads());
  }
}

TEST_P(Pools, ThrowWhatTheLowestThreadThrewAndGoOn) {
  for (int call = 0; call < 20; ++call) {
    const auto boom = [&](std::size_t, std::size_t, std::size_t range) {
      throw std::runtime_error(std::to_string(range));
    };
    try {
      pool.forRanges(100, 1, boom);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0");
    }
    std::atomic<int> calls = 0;
    pool.run([&](int, Barrier&) { ++calls; });
    EXPECT_EQ(calls, pool.threads());
  }
}

TEST_P(Pools, DoNotWaitAtTheBarrierForWhoHasThrown) {
  const int culprit = pool.threads() - 1;
  for (int call = 0; call < 20; ++call) {
    const auto work = [&](int thread, Barrier& barrier) {
      for (int p = 0; p < 100; ++p) {
        if (thread == culprit && p == call) throw std::runtime_error("culprit");
        barrier.wait();
      }
    };
    EXPECT_THROW(pool.run(work), std::runtime_error);
    std::atomic<int> calls = 0;
    pool.run([&](int, Barrier& barrier) {
      barrier.wait();
      ++calls;
      barrier.wait();
    });
    EXPECT_EQ(calls, pool.threads());
  }
}

TEST(ThreadPool, OfOneStartsNoThread) {
  const auto caller = std::this_thread::get_id();
  ThreadPool pool(1);
  EXPECT_EQ(pool.threads(), 1);
  pool.run([&](int thread, Barrier& barrier) {
    EXPECT_EQ(thread, 0);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    barrier.wait();
  });
}

TEST(ThreadPool, TwoWorkSideBySide) {
  ThreadPool first(2);
  ThreadPool second(3);
  int sum = 0;
  first.run([&](int thread, Barrier&) {
    if (thread == 1) return;
    second.run([&](int inner, Barrier& barrier) {
      barrier.wait();
      if (inner == 2) sum += 2;
    });
    ++sum;
  });
  EXPECT_EQ(sum, 3);
}

TEST(ThreadPool, RefusesNumbersThatItCannotBeOf) {
  EXPECT_THROW(ThreadPool(0), std::invalid_argument);
  try {
    ThreadPool pool(kMostThreads + 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "65 threads; allowed: 1 to 64");
  }
}

}  // namespace
}  // namespace wells
