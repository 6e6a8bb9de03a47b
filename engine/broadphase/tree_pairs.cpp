#include "broadphase/tree_pairs.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <cmath>

// Bullet's two builds share their headers; a forgotten BT_USE_DOUBLE_PRECISION would link and then
// read floats as doubles.
static_assert(sizeof(btScalar) == sizeof(double), "the broadphase needs Bullet's double build");

namespace wells {
namespace {

// What is added to a swept box, in radii. Larger: fewer proxies move, more pairs are listed.
// T1 with 10,000 balls, 300 steps: see README.md, "Benchmark".
constexpr double kFattening = 0.5;
// Steps: by how many of its motion a box that is set anew reaches ahead. T2 with 10,000 balls: 7.1
// ms a step with 0, 4.1 with 4, 4.5 with 8; T1 does not mind.
constexpr double kAhead = 4;
// Each ball that is removed costs a look at all pairs; where more are, the tree is built afresh.
constexpr std::size_t kMostRemoved = 16;

btVector3 toBullet(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

// Which ball a proxy stands for is kept in Bullet's user pointer.
void* asClient(std::uint32_t ball) {
  return reinterpret_cast<void*>(std::uintptr_t{ball});
}

std::uint32_t ballOf(const btBroadphaseProxy* proxy) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy->m_clientObject));
}

struct Collector : btBroadphaseAabbCallback {
  std::vector<std::uint32_t>* found = nullptr;

  bool process(const btBroadphaseProxy* proxy) override {
    found->push_back(ballOf(proxy));
    return true;
  }
};

}  // namespace

struct TreePairs::Tree {
  btDbvtBroadphase broadphase;
  std::vector<btBroadphaseProxy*> ofBall;  // null: in no pair

  explicit Tree(std::size_t balls) : ofBall(balls, nullptr) {
    broadphase.m_deferedcollide = true;  // one pass over the trees instead of one per proxy
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  // Bullet leaves proxies to whoever created them. The pairs go first, because each proxy would
  // search all of them for its own.
  ~Tree() {
    pairs().clear();
    for (auto* const proxy : ofBall)
      if (proxy) broadphase.destroyProxy(proxy, nullptr);
  }

  btBroadphasePairArray& pairs() {
    return broadphase.getOverlappingPairCache()->getOverlappingPairArray();
  }
};

TreePairs::TreePairs(std::size_t balls) : tree_(std::make_unique<Tree>(balls)) {}
TreePairs::~TreePairs() = default;

std::int64_t TreePairs::update(const World& world, std::span<const double> reach,
                               std::span<const std::uint32_t> among, ThreadPool& threads,
                               std::vector<BallPair>& pairs) {
  for (const std::uint32_t i : among) {
    if (isFinite(world.balls.position[i]) && std::isfinite(reach[i]))
      setBox(world, reach[i], i);
    else
      removeBox(i);
  }
  // Boxes that stand where they stood have the pairs that they had.
  if (moved_ == 0) return 0;
  tree_->broadphase.calculateOverlappingPairs(nullptr);
  const btBroadphasePairArray& found = tree_->pairs();
  const auto forEachIn = [&](std::size_t, auto visit) {
    for (int n = 0; n < found.size(); ++n)
      visit(ballOf(found[n].m_pProxy0), ballOf(found[n].m_pProxy1));
  };
  sorter_.sort(tree_->ofBall.size(), 1, threads, forEachIn, pairs);
  return std::exchange(moved_, 0);
}

void TreePairs::setBox(const World& world, double reach, std::uint32_t ball) {
  const Balls& balls = world.balls;
  btBroadphaseProxy*& proxy = tree_->ofBall[ball];
  const double half = balls.radius[ball] + reach;
  const Vec3 swept = Vec3::Constant(half);
  const Vec3 fat = Vec3::Constant(half + kFattening * balls.radius[ball]);
  const Vec3& x = balls.position[ball];
  const Vec3 ahead = balls.velocity[ball] * (kAhead * world.settings.dt);
  const btVector3 fatLow = toBullet(x - fat + ahead.cwiseMin(0));
  const btVector3 fatHigh = toBullet(x + fat + ahead.cwiseMax(0));
  if (!proxy) {
    proxy = tree_->broadphase.createProxy(fatLow, fatHigh, 0, asClient(ball), 1, 1, nullptr);
    ++moved_;
    return;
  }
  const btVector3 low = toBullet(x - swept);
  const btVector3 high = toBullet(x + swept);
  const bool inside = low.x() >= proxy->m_aabbMin.x() && high.x() <= proxy->m_aabbMax.x() &&
                      low.y() >= proxy->m_aabbMin.y() && high.y() <= proxy->m_aabbMax.y() &&
                      low.z() >= proxy->m_aabbMin.z() && high.z() <= proxy->m_aabbMax.z();
  if (inside) return;
  tree_->broadphase.setAabb(proxy, fatLow, fatHigh, nullptr);
  ++moved_;
}

void TreePairs::remove(std::span<const std::uint32_t> balls) {
  if (balls.size() > kMostRemoved) {
    moved_ += static_cast<std::int64_t>(balls.size());
    tree_ = std::make_unique<Tree>(tree_->ofBall.size());
    return;
  }
  for (const std::uint32_t i : balls) removeBox(i);
}

void TreePairs::removeBox(std::uint32_t ball) {
  btBroadphaseProxy*& proxy = tree_->ofBall[ball];
  if (!proxy) return;
  tree_->broadphase.destroyProxy(proxy, nullptr);
  proxy = nullptr;
  ++moved_;
}

void TreePairs::findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found) {
  Collector collector;
  collector.found = &found;
  tree_->broadphase.aabbTest(toBullet(low), toBullet(high), collector);
}

}  // namespace wells
