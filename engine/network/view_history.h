// What this peer showed: the positions of all balls at the last steps, to be held against the
// owners' states that arrive later.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vector.h"

namespace wells {

class ViewHistory {
 public:
  static constexpr std::int64_t kSteps = 64;  // about a second

  /// Keeps what is shown at `step`. Showing a step again (a state of this step came) replaces it.
  void record(std::int64_t step, const std::vector<Vec3>& positions);

  /// Where a ball was shown at `step`; nothing when that is too long ago or was never shown.
  std::optional<Vec3> at(std::int64_t step, std::size_t ball) const;

  void clear() { views_ = {}; }

 private:
  struct View {
    std::int64_t step = -1;
    std::vector<Vec3> positions;  // m
  };
  std::array<View, kSteps> views_;
};

/// The largest of the differences between views and owners' states.
class ViewDifference {
 public:
  void add(double difference, double now);

  double largest() const { return largest_; }  // m, since the start

  /// m, of the last second (to a tenth of it).
  double recent(double now) const;

 private:
  static constexpr std::size_t kBuckets = 11;  // tenths of a second, the running one included
  struct Bucket {
    std::int64_t tenth = -1;
    double largest = 0;
  };
  double largest_ = 0;
  std::array<Bucket, kBuckets> buckets_{};
};

}  // namespace wells
