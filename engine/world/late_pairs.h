// Counts pairs that came too late: already deep in overlap when they were first announced, by balls
// that took part in the step before. The broadphase, or our bound on how far a ball moves, has then
// missed them; the count must be 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "state/world.h"
#include "threads/thread_pool.h"
#include "world/candidates.h"

namespace wells {

class LatePairs {
 public:
  /// At the end of a step, in which the balls `awake` took part, began in the middle of start[ball]
  /// and could touch as `pairs` (by (a, b)) have it. Other peers' balls do not count, for they jump
  /// when their states arrive.
  std::int64_t count(const World& world, std::span<const BallPair> pairs,
                     std::span<const Candidates::Sphere> start,
                     std::span<const std::uint32_t> awake, ThreadPool& threads);

 private:
  std::int64_t countIn(IndexRange range, const World& world, std::span<const BallPair> pairs,
                       std::span<const Candidates::Sphere> start) const;
  void keep(std::span<const BallPair> pairs);
  bool isLate(const World& world, const BallPair& pair,
              std::span<const Candidates::Sphere> start) const;

  // The pairs of the step before: for each ball a that had any, the other balls.
  struct List {
    std::uint32_t a;
    std::uint32_t end;  // of its partners, where those of the next begin
  };
  std::vector<List> lists_;
  std::vector<std::uint32_t> partners_;
  std::vector<std::uint32_t> nextStep_;  // by ball, the number of that after its last one
};

}  // namespace wells
