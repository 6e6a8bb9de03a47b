// Which balls may touch what, by Bullet's tree of boxes (btDbvtBroadphase): those whose boxes
// overlap. A box holds the ball wherever it may get in the step, is fattened and reaches ahead, and
// is set anew only when the ball leaves it. For balls of any sizes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "state/world.h"

namespace wells {

class TreePairs {
 public:
  TreePairs(std::size_t balls, const Arena& arena);
  ~TreePairs();
  TreePairs(const TreePairs&) = delete;
  TreePairs& operator=(const TreePairs&) = delete;

  /// As Broadphase::update() has it. Returns how many boxes were set or removed.
  std::int64_t update(const World& world, std::span<const double> reach,
                      std::span<const std::uint32_t> among, ThreadPool& threads,
                      CandidateLists& lists);

  void remove(std::span<const std::uint32_t> balls);

  /// As Broadphase::findIn() has it.
  void findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found);

 private:
  struct Tree;
  void setBox(const World& world, double reach, std::uint32_t ball);
  void removeBox(std::uint32_t ball);

  std::unique_ptr<Tree> tree_;
  std::int64_t moved_ = 0;  // boxes, since the last update
  PairSorter sorter_;
};

}  // namespace wells
