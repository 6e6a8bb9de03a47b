#include "network/gathering.h"

#include <algorithm>
#include <limits>

namespace wells {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

}  // namespace

Gathering::Gathering(std::size_t balls)
    : steps_(balls, -1), heardAt_(balls, kNever), confirmedAt_(balls, kNever), missing_(balls) {}

void Gathering::restart() {
  *this = Gathering(steps_.size());
}

void Gathering::keep(std::int64_t step) {
  restart();
  std::ranges::fill(steps_, step);
  missing_ = 0;
}

void Gathering::hear(std::size_t ball, std::int64_t step, double now) {
  if (steps_[ball] < 0) --missing_;
  steps_[ball] = step;
  heardAt_[ball] = now;
}

void Gathering::compare(std::span<const Record> records, std::size_t bucket,
                        const BucketDigest& theirs, double recently, double now) {
  const bool agrees = digestSum(records, bucket, theirs.known) == theirs.sum;
  const std::size_t first = bucket * kBallsInBucket;
  const std::size_t end = std::min(first + kBallsInBucket, records.size());
  for (std::size_t ball = first; ball < end; ++ball) {
    const bool counts = theirs.known[ball - first];
    if (counts ? agrees : heardAt_[ball] >= recently) confirmedAt_[ball] = now;
  }
}

bool Gathering::isComplete(double time) const {
  return missing_ == 0 && std::ranges::all_of(confirmedAt_, [&](double at) { return at >= time; });
}

std::int64_t Gathering::latestStep() const {
  return steps_.empty() ? 0 : std::max<std::int64_t>(0, std::ranges::max(steps_));
}

}  // namespace wells
