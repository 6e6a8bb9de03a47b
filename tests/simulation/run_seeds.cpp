#include "simulation/run_seeds.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace wells::simulation {

SeedsOutcome runSeeds(std::uint64_t first, std::int64_t count, const SessionShape& shape, int jobs,
                      const std::function<void(const Tally&, std::size_t)>& progress) {
  SeedsOutcome all;
  std::mutex mutex;
  std::atomic<std::int64_t> next = 0;
  const auto work = [&] {
    for (std::int64_t i = next++; i < count; i = next++) {
      const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
      Outcome outcome = simulate(drawSchedule(seed, shape));
      const std::lock_guard lock(mutex);
      all.tally += outcome.tally;
      if (outcome.tally.handovers < kFewHandovers) all.fewHandovers.push_back(seed);
      if (!outcome.violations.empty())
        all.failures.push_back({seed, std::move(outcome.violations.front())});
      if (progress) progress(all.tally, all.failures.size());
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
  work();
  threads.clear();
  std::ranges::sort(all.failures, {}, &Failure::seed);
  std::ranges::sort(all.fewHandovers);
  return all;
}

}  // namespace wells::simulation
