#include "broadphase/broadphase.h"

#include <algorithm>

namespace wells {
namespace {

// Cells are as large as the largest balls, so that one may hold as many as the cube of this times
// more small ones. 10,000 balls, half filling their space, all of which move: up to a ratio of 8
// the grid took 2.0 to 2.8 ms a step and the tree more than 100, but a tenth were large; a few
// large ones among many small cost the grid most.
constexpr double kMostUnequalRadii = 3;

}  // namespace

BroadphaseKind broadphaseFor(std::span<const double> radii) {
  if (radii.empty()) return BroadphaseKind::Grid;
  const auto [least, most] = std::ranges::minmax(radii);
  return most <= kMostUnequalRadii * least ? BroadphaseKind::Grid : BroadphaseKind::Tree;
}

bool Broadphase::isBuiltFor(const World& world) const {
  return (tree_ || spheres_) && balls_ == world.balls.size() &&
         arena_.center == world.arena.center && arena_.radius == world.arena.radius &&
         chosen_ == world.settings.broadphase;
}

void Broadphase::build(const World& world) {
  balls_ = world.balls.size();
  arena_ = world.arena;
  chosen_ = world.settings.broadphase;
  tree_.reset();
  spheres_.reset();
  lists_ = {};
  if ((chosen_ == BroadphaseKind::Auto ? broadphaseFor(world.balls.radius) : chosen_) ==
      BroadphaseKind::Tree)
    tree_ = std::make_unique<TreePairs>(balls_, arena_);
  else
    spheres_ = std::make_unique<SpherePairs>(balls_, arena_);
}

void Broadphase::update(const World& world, std::span<const double> reach,
                        std::span<const std::uint32_t> among, ThreadPool* threads) {
  if (!isBuiltFor(world)) build(world);
  ThreadPool& pool = threads ? *threads : alone_;
  moved_ = tree_ ? tree_->update(world, reach, among, pool, lists_)
                 : spheres_->update(world, reach, among, pool, lists_);
}

void Broadphase::remove(std::span<const std::uint32_t> balls) {
  if (tree_) tree_->remove(balls);
  if (spheres_) spheres_->remove(balls);
}

void Broadphase::findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found) {
  if (tree_) tree_->findIn(low, high, found);
  if (spheres_) spheres_->findIn(low, high, found);
}

}  // namespace wells
