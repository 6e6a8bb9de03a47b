// Threads that share the work of one caller: it hands out a function, takes part in it, and goes on
// when all have done theirs. Between calls they spin for a moment and then sleep. Not a queue of
// tasks: there is one call at a time, and what each thread does follows from its number alone, so
// that results are the same in every run.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

#include "threads/barrier.h"

namespace wells {

inline constexpr int kMostThreads = 64;

/// From begin up to, not including, end.
struct IndexRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Part number `part` of `parts` of 0 .. count-1. All begin at multiples of `grain` and differ by
/// one grain at most; some are empty where there are fewer grains than parts.
constexpr IndexRange partOf(std::size_t count, std::size_t grain, std::size_t part,
                            std::size_t parts) {
  const std::size_t grains = (count + grain - 1) / grain;
  return {std::min(count, grains * part / parts * grain),
          std::min(count, grains * (part + 1) / parts * grain)};
}

class ThreadPool {
 public:
  /// Of 1 to kMostThreads threads, the caller's among them; of one all calls are plain ones. The
  /// others may run where the thread that makes the pool may. Throws std::invalid_argument, or
  /// std::system_error where a thread cannot be had.
  explicit ThreadPool(int threads = 1);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return threads_; }

  /// Calls f(thread, barrier) in all threads at once, thread = 0 (the caller) .. threads()-1, and
  /// returns when all have returned. They may wait at the barrier, all of them equally often. What
  /// the lowest thread threw is thrown; the others then leave at their next barrier. Allocates
  /// nothing. f must not call the pool.
  template <typename F>
  void run(F&& f) {
    Barrier& barrier = barrier_;
    if (threads_ == 1) return void(f(0, barrier));
    using Function = std::remove_reference_t<F>;
    start({[](void* function, int thread, Barrier& b) {
             (*static_cast<Function*>(function))(thread, b);
           },
           const_cast<void*>(static_cast<const void*>(std::addressof(f)))});
  }

  /// Into how many ranges forRanges() divides: as many as there are threads, but none shorter than
  /// `grain`, > 0.
  std::size_t ranges(std::size_t count, std::size_t grain) const {
    return std::clamp<std::size_t>(count / grain, 1, static_cast<std::size_t>(threads_));
  }

  /// Calls f(begin, end, range) for ranges that together are 0 .. count-1, in rising order, each in
  /// another thread; the first range is the caller's. They begin at multiples of `grain`. One range
  /// is a plain call. Throws what the first of those that threw has thrown.
  template <typename F>
  void forRanges(std::size_t count, std::size_t grain, F&& f) {
    const std::size_t parts = ranges(count, grain);
    if (parts == 1) return void(f(std::size_t{0}, count, std::size_t{0}));
    run([&](int thread, Barrier&) {
      const auto range = static_cast<std::size_t>(thread);
      if (range >= parts) return;
      const IndexRange part = partOf(count, grain, range, parts);
      f(part.begin, part.end, range);
    });
  }

 private:
  struct Job {
    void (*call)(void* function, int thread, Barrier& barrier) = nullptr;
    void* function = nullptr;
  };

  void start(Job job);
  void work(int thread);
  void take(int thread);
  void stop();

  const int threads_;
  const int spins_;
  Job job_;
  bool isStopping_ = false;
  std::mutex failureMutex_;
  int failed_ = kMostThreads;  // the lowest thread that threw
  std::exception_ptr failure_;
  Barrier barrier_;
  alignas(64) std::atomic<std::uint32_t> jobs_{0};     // handed out so far
  alignas(64) std::atomic<std::uint32_t> working_{0};  // threads but the caller's
  std::vector<std::thread> workers_;
};

}  // namespace wells
