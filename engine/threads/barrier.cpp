#include "threads/barrier.h"

#include <immintrin.h>

namespace wells {

void waitWhileEqual(const std::atomic<std::uint32_t>& value, std::uint32_t old, int spins) {
  for (int i = 0; i < spins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    _mm_pause();
  }
  value.wait(old, std::memory_order_acquire);
}

// The phase changes by a read-modify-write in one total order with the count of sleepers that
// notify_all() looks at. After a plain store it could miss one who has just looked.
void Barrier::open() {
  phase_.fetch_add(1, std::memory_order_seq_cst);
  phase_.notify_all();
}

void Barrier::waitForOthers() {
  // Before the question whether somebody has given up, who does so first and then opens: either we
  // see that, or the phase that we know will end.
  const std::uint32_t phase = phase_.load(std::memory_order_seq_cst);
  if (isAbandoned_.load(std::memory_order_seq_cst)) throw Broken{};
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
    arrived_.store(0, std::memory_order_relaxed);
    open();
  } else {
    waitWhileEqual(phase_, phase, spins_);
  }
  if (isAbandoned_.load(std::memory_order_acquire)) throw Broken{};
}

void Barrier::abandon() {
  isAbandoned_.store(true, std::memory_order_seq_cst);
  open();
}

void Barrier::repair() {
  arrived_.store(0, std::memory_order_relaxed);
  isAbandoned_.store(false, std::memory_order_relaxed);
}

}  // namespace wells
