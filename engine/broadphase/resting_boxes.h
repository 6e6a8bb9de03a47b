// The boxes of balls that stand still, for balls that move to ask whom they may meet. Nothing is
// spent on them while nobody asks; Broadphase is for those that move.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "math/vector.h"

namespace wells {

class RestingBoxes {
 public:
  RestingBoxes();
  ~RestingBoxes();
  RestingBoxes(const RestingBoxes&) = delete;
  RestingBoxes& operator=(const RestingBoxes&) = delete;

  void clear();

  /// Ball `ball`, which is not there, within `half` (m) of its centre in each direction.
  void add(std::uint32_t ball, const Vec3& center, double half);
  /// A ball that is there.
  void remove(std::uint32_t ball);

  /// Appends the balls whose boxes overlap that from low to high (m), in no particular order. O(log
  /// n) and what is found.
  void find(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace wells
