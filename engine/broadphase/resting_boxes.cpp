#include "broadphase/resting_boxes.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include "broadphase/bullet_proxy.h"

namespace wells {
namespace {

struct Collector : btDbvt::ICollide {
  std::vector<std::uint32_t>* found = nullptr;

  void Process(const btDbvtNode* leaf) override {
    found->push_back(static_cast<std::uint32_t>(leaf->dataAsInt));
  }
};

}  // namespace

struct RestingBoxes::Tree {
  btDbvt boxes;
  std::vector<btDbvtNode*> leaves;  // by ball; null: not there
  btAlignedObjectArray<const btDbvtNode*> stack;
  Collector collector;
};

RestingBoxes::RestingBoxes() : tree_(std::make_unique<Tree>()) {}
RestingBoxes::~RestingBoxes() = default;

void RestingBoxes::clear() {
  tree_->boxes.clear();
  tree_->leaves.clear();
}

void RestingBoxes::add(std::uint32_t ball, const Vec3& center, double half) {
  if (ball >= tree_->leaves.size()) tree_->leaves.resize(ball + 1, nullptr);
  const Vec3 reach = Vec3::Constant(half);
  btDbvtNode* const leaf = tree_->boxes.insert(
      btDbvtVolume::FromMM(toBullet(center - reach), toBullet(center + reach)), nullptr);
  leaf->dataAsInt = static_cast<int>(ball);
  tree_->leaves[ball] = leaf;
}

void RestingBoxes::remove(std::uint32_t ball) {
  tree_->boxes.remove(tree_->leaves[ball]);
  tree_->leaves[ball] = nullptr;
}

void RestingBoxes::find(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found) {
  tree_->collector.found = &found;
  tree_->boxes.collideTVNoStackAlloc(tree_->boxes.m_root,
                                     btDbvtVolume::FromMM(toBullet(low), toBullet(high)),
                                     tree_->stack, tree_->collector);
}

}  // namespace wells
