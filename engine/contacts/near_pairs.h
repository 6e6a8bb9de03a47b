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
  /// in `balls`, of whose places and momenta `arrays` has the records. Duration of the step in s.
  void find(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
            std::span<const std::uint32_t> place, double duration, const CrowdArrays& arrays,
            ThreadPool& pool);

  /// Near ones, in the order of `balls`; indices of balls.
  std::span<const IndexPair> pairs() const { return near_; }
  /// By ball, the first of pairs() that it has as a; one more behind the last ball.
  std::span<const std::uint32_t> firstOf() const { return firstOf_; }

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
              double duration, const CrowdArrays& arrays, IndexRange balls, Part& part);

  std::vector<IndexPair> near_;
  std::vector<std::uint32_t> firstOf_;
  std::vector<Run> runOf_;  // by ball, those given that it has as a
  std::array<Part, kMostThreads> parts_;
};

}  // namespace wells
