// Where threads that work in step wait for each other, hundreds of times in a millisecond: waits by
// spinning, and sleeps when that takes too long, because a machine that is shared may have taken
// somebody's processor away. Not for threads that come and go: see thread_pool.h.
#pragma once

#include <atomic>
#include <cstdint>

namespace wells {

/// Returns once `value` is no longer `old`: spins so many times, then sleeps until it is notified.
void waitWhileEqual(const std::atomic<std::uint32_t>& value, std::uint32_t old, int spins);

class Barrier {
 public:
  /// Of `threads` threads, >= 1, which spin so many times before they sleep.
  Barrier(int threads, int spins) : threads_(threads), spins_(spins) {}

  /// Thrown by wait() where a thread will never come.
  struct Broken {};

  /// Returns when all threads have called it; what they wrote before is then seen by all. Throws
  /// Broken after abandon().
  void wait() {
    if (threads_ > 1) waitForOthers();
  }

  /// For a thread that cannot go on: the others' waits throw.
  void abandon();

  /// As new. Nobody may be inside.
  void repair();

 private:
  void waitForOthers();
  void open();

  const int threads_;
  const int spins_;
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<std::uint32_t> phase_{0};
  std::atomic<bool> isAbandoned_{false};
};

}  // namespace wells
