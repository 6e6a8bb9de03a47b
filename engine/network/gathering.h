// What a peer that syncs has of each ball: the step of the state that it holds, and when its
// records last agreed with those of each active peer.
//
// They agree by digests. A digest counts the balls whose owner the active peer has known for a
// while; the others are changing hands right then, and for those it is enough to hold a state of a
// recent step from an owner that lives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "ownership/digest.h"

namespace wells {

class Gathering {
 public:
  explicit Gathering(std::size_t balls);

  /// Holds nothing.
  void restart();

  /// Holds states of `step` from before, of which nothing is confirmed any more.
  void keep(std::int64_t step);

  /// A state of `step`, or an offer with it, was heard and is held.
  void hear(std::size_t ball, std::int64_t step);

  /// An active peer's digest of `bucket`, held against our records. `isRecent` tells of a record
  /// and the step of the state that is held.
  void compare(std::span<const Record> records, const Incarnation& peer, std::size_t bucket,
               const BucketDigest& theirs, double now,
               const std::function<bool(const Record&, std::int64_t step)>& isRecent);

  bool has(std::size_t ball) const { return steps_[ball] >= 0; }
  std::int64_t stepOf(std::size_t ball) const { return steps_[ball]; }

  /// Balls of which no state is held.
  std::size_t missing() const { return missing_; }

  /// True when each record agreed with that of each of `peers` at `time` (s) or later.
  bool agrees(std::span<const Incarnation> peers, double time) const;

  /// Of the states that are held; 0: none.
  std::int64_t latestStep() const;

 private:
  std::vector<std::int64_t> steps_;                      // of the state that is held; -1: none
  std::map<Incarnation, std::vector<double>> agreedAt_;  // s, by ball
  std::size_t missing_ = 0;
};

}  // namespace wells
