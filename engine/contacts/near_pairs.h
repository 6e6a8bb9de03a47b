// Which pairs of a crowd are worth keeping ready as contacts. All that the balls may reach in a
// step are many times those that touch, so they are divided: near are pairs whose balls come close
// if nothing deflects them. The others are far, and only looked at in each substep.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "contacts/crowd_kernels.h"
#include "threads/thread_pool.h"

namespace wells {

class NearPairs {
 public:
  /// Divides `pairs`, all between balls of `balls` and by (a, b). place[id] is the place of ball id
  /// in `balls`, places[k] and momenta[k] what is there. Duration of the step in s.
  void find(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
            std::span<const std::uint32_t> place, double duration, const Place* places,
            const Momentum* momenta, ThreadPool& pool);

  PairsByBall near() const { return {near_, firstOf_}; }

  /// Far ones, in the order of `balls` if taken part by part; each thread of the pool has one.
  std::span<IndexPair> far(std::size_t thread) { return parts_[thread].far; }

 private:
  /// What a thread found.
  struct alignas(64) Part {
    std::vector<IndexPair> near;
    std::vector<IndexPair> far;
    std::vector<IndexPair> block;  // scratch
    std::vector<std::uint8_t> isNear;
  };
  struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  void divide(std::span<const BallPair> pairs, std::span<const std::uint32_t> place,
              double duration, const Place* places, const Momentum* momenta, IndexRange balls,
              Part& part);

  std::vector<IndexPair> near_;
  std::vector<std::uint32_t> firstOf_;
  std::vector<Run> runOf_;  // by ball, those given that it has as a
  std::array<Part, kMostThreads> parts_;
};

}  // namespace wells
