#include "network/gathering.h"

#include <algorithm>
#include <limits>

namespace wells {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

}  // namespace

Gathering::Gathering(std::size_t balls) : steps_(balls, -1), missing_(balls) {}

void Gathering::restart() {
  *this = Gathering(steps_.size());
}

void Gathering::keep(std::int64_t step) {
  restart();
  std::ranges::fill(steps_, step);
  missing_ = 0;
}

void Gathering::hear(std::size_t ball, std::int64_t step) {
  if (steps_[ball] < 0) --missing_;
  steps_[ball] = step;
}

void Gathering::compare(std::span<const Record> records, const Incarnation& peer,
                        std::size_t bucket, const BucketDigest& theirs, double now,
                        const std::function<bool(const Record&, std::int64_t step)>& isRecent) {
  auto& times = agreedAt_.try_emplace(peer, records.size(), kNever).first->second;
  // Where they differ, what the peer has said before no longer counts.
  const bool agrees = digestSum(records, bucket, theirs.known) == theirs.sum;
  const std::size_t first = bucket * kBallsInBucket;
  const std::size_t end = std::min(first + kBallsInBucket, records.size());
  for (std::size_t ball = first; ball < end; ++ball) {
    if (!agrees)
      times[ball] = kNever;
    else if (theirs.known[ball - first] || isRecent(records[ball], steps_[ball]))
      times[ball] = now;
  }
}

bool Gathering::agrees(std::span<const Incarnation> peers, double time) const {
  const auto agreed = [&](const Incarnation& peer) {
    const auto times = agreedAt_.find(peer);
    return times != agreedAt_.end() &&
           std::ranges::all_of(times->second, [&](double at) { return at >= time; });
  };
  return std::ranges::all_of(peers, agreed);
}

std::int64_t Gathering::latestStep() const {
  return steps_.empty() ? 0 : std::max<std::int64_t>(0, std::ranges::max(steps_));
}

}  // namespace wells
