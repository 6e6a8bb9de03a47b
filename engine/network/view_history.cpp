#include "network/view_history.h"

#include <algorithm>
#include <cmath>

namespace wells {
namespace {

std::size_t slotOf(std::int64_t step) {
  return static_cast<std::size_t>(step % ViewHistory::kSteps);
}

std::int64_t tenthOf(double now) {
  return static_cast<std::int64_t>(std::floor(now * 10));
}

}  // namespace

void ViewHistory::record(std::int64_t step, const std::vector<Vec3>& positions) {
  View& view = views_[slotOf(step)];
  view.step = step;
  view.positions = positions;  // keeps its memory from the last time round
}

std::optional<Vec3> ViewHistory::at(std::int64_t step, std::size_t ball) const {
  const View& view = views_[slotOf(step)];
  if (view.step != step) return std::nullopt;
  return view.positions[ball];
}

void ViewDifference::add(double difference, double now) {
  largest_ = std::max(largest_, difference);
  const std::int64_t tenth = tenthOf(now);
  Bucket& bucket = buckets_[static_cast<std::size_t>(tenth) % kBuckets];
  if (bucket.tenth != tenth) bucket = {tenth, 0};
  bucket.largest = std::max(bucket.largest, difference);
}

double ViewDifference::recent(double now) const {
  double largest = 0;
  for (const Bucket& bucket : buckets_)
    if (bucket.tenth > tenthOf(now) - static_cast<std::int64_t>(kBuckets))
      largest = std::max(largest, bucket.largest);
  return largest;
}

}  // namespace wells
