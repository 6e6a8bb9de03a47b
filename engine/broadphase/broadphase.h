// Candidate pairs from a broadphase of Bullet's interface, its tree of boxes or a grid: which balls
// may touch which balls, the ground or the wall during a step.
//
// Balls, ground and wall are proxies. A ball's box is made larger than the step needs and set anew
// only when the ball leaves it, so that one list of pairs serves many steps. The pairs are a
// superset: what is near is decided by exact gaps, in contacts/.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "broadphase/sphere_pairs.h"
#include "broadphase/tree_pairs.h"
#include "state/world.h"
#include "threads/thread_pool.h"

namespace wells {

/// What BroadphaseKind::Auto means for balls of these radii. A grid where they are about the same,
/// else a tree.
BroadphaseKind broadphaseFor(std::span<const double> radii);

class Broadphase {
 public:
  /// Brings the boxes up to date and lists the candidate pairs. reach[i] (m, >= 0) bounds how far
  /// ball i may move in the step: every pair whose gap is at most the sum of its reaches is
  /// listed. A change in the number of balls, in the arena or in Settings::broadphase starts
  /// afresh. A ball whose position or reach is not finite is in no pair. `among` are the balls that
  /// take part: all that did so in the last update and have not been removed since, and any others.
  /// O(among), and what their pairs cost.
  void update(const World& world, std::span<const double> reach,
              std::span<const std::uint32_t> among, ThreadPool* threads = nullptr);

  /// These take no part from the next update on, until they are among its balls again.
  void remove(std::span<const std::uint32_t> balls);

  /// Of the last update, by (a, b), each once.
  const std::vector<BallPair>& ballPairs() const { return lists_.ballPairs; }
  /// In no particular order.
  const std::vector<std::uint32_t>& nearGround() const { return lists_.nearGround; }
  /// Likewise; a ball may stand several times, once for each piece of the ring that it is near.
  const std::vector<std::uint32_t>& nearWall() const { return lists_.nearWall; }

  /// Whether each of the pairs of balls has a gap that is at most the sum of the reaches.
  bool areNear() const { return spheres_ && spheres_->areNear(); }

  /// Appends balls of the last update, in no particular order: all that may come, within their
  /// reaches, to a place from low to high (m), and others.
  void findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found);

  /// Proxies that the last update moved, added or removed, for benchmarks.
  std::int64_t moved() const { return moved_; }

 private:
  bool isBuiltFor(const World& world) const;
  void build(const World& world);

  // One of the two, once there is one.
  std::unique_ptr<TreePairs> tree_;
  std::unique_ptr<SpherePairs> spheres_;
  BroadphaseKind chosen_ = BroadphaseKind::Auto;  // in the settings
  std::size_t balls_ = 0;
  Arena arena_;
  CandidateLists lists_;
  std::int64_t moved_ = 0;
  ThreadPool alone_;
};

}  // namespace wells
