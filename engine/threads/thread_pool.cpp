#include "threads/thread_pool.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "threads/placement.h"

namespace wells {
namespace {

// Half a millisecond, so that nobody falls asleep while the caller does by itself what cannot be
// shared: waking takes 50 us and more. With 25 us a second thread sped T1 with 10,000 balls up by
// 1.25, with this by 1.6.
constexpr int kSpins = 20000;

int checked(int threads) {
  if (threads < 1 || threads > kMostThreads)
    throw std::invalid_argument(fmt::format("{} threads; allowed: 1 to {}", threads, kMostThreads));
  return threads;
}

// Whoever spins for a thread that has no processor of its own keeps it from running.
int spinsFor(int threads) {
  if (threads == 1) return 0;
  return allowedCores().size() < static_cast<std::size_t>(threads) ? 0 : kSpins;
}

}  // namespace

ThreadPool::ThreadPool(int threads)
    : threads_(checked(threads)), spins_(spinsFor(threads_)), barrier_(threads_, spins_) {
  workers_.reserve(static_cast<std::size_t>(threads_ - 1));
  try {
    for (int thread = 1; thread < threads_; ++thread)
      workers_.emplace_back([this, thread] { work(thread); });
  } catch (...) {
    stop();
    throw;
  }
}

ThreadPool::~ThreadPool() {
  stop();
}

void ThreadPool::stop() {
  isStopping_ = true;
  jobs_.fetch_add(1, std::memory_order_seq_cst);
  jobs_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::start(Job job) {
  job_ = job;
  working_.store(static_cast<std::uint32_t>(threads_ - 1), std::memory_order_relaxed);
  jobs_.fetch_add(1, std::memory_order_seq_cst);  // as Barrier::open()
  jobs_.notify_all();
  take(0);
  for (std::uint32_t left; (left = working_.load(std::memory_order_acquire)) != 0;)
    waitWhileEqual(working_, left, spins_);
  if (failed_ == kMostThreads) return;
  failed_ = kMostThreads;
  barrier_.repair();
  std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::work(int thread) {
  nameThisThread(fmt::format("simulation {}", thread + 1));
  for (std::uint32_t seen = 0;; ++seen) {
    waitWhileEqual(jobs_, seen, spins_);
    if (isStopping_) return;
    take(thread);
    working_.fetch_sub(1, std::memory_order_seq_cst);
    working_.notify_one();
  }
}

void ThreadPool::take(int thread) {
  try {
    job_.call(job_.function, thread, barrier_);
  } catch (const Barrier::Broken&) {
    // Somebody else has thrown, and says what.
  } catch (...) {
    {
      const std::lock_guard lock(failureMutex_);
      if (thread < failed_) {
        failed_ = thread;
        failure_ = std::current_exception();
      }
    }
    barrier_.abandon();
  }
}

}  // namespace wells
