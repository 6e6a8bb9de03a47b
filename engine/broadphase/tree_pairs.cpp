#include "broadphase/tree_pairs.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "broadphase/arena_boxes.h"
#include "broadphase/ball_collector.h"
#include "broadphase/bullet_proxy.h"

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

}  // namespace

struct TreePairs::Tree {
  btDbvtBroadphase broadphase;
  Arena arena;
  std::vector<btBroadphaseProxy*> ofArena;
  std::vector<btBroadphaseProxy*> ofBall;  // null: in no pair

  Tree(std::size_t balls, const Arena& its)
      : arena(its), ofArena(addArena(its, broadphase)), ofBall(balls, nullptr) {
    broadphase.m_deferedcollide = true;  // one pass over the trees instead of one per proxy
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  // Bullet leaves proxies to whoever created them. The pairs go first, because each proxy would
  // search all of them for its own.
  ~Tree() {
    pairs().clear();
    for (auto* const proxy : ofArena) broadphase.destroyProxy(proxy, nullptr);
    for (auto* const proxy : ofBall)
      if (proxy) broadphase.destroyProxy(proxy, nullptr);
  }

  btBroadphasePairArray& pairs() {
    return broadphase.getOverlappingPairCache()->getOverlappingPairArray();
  }
};

TreePairs::TreePairs(std::size_t balls, const Arena& arena)
    : tree_(std::make_unique<Tree>(balls, arena)) {}
TreePairs::~TreePairs() = default;

std::int64_t TreePairs::update(const World& world, std::span<const double> reach,
                               std::span<const std::uint32_t> among, ThreadPool& threads,
                               CandidateLists& lists) {
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
  lists.nearGround.clear();
  lists.nearWall.clear();
  for (int n = 0; n < found.size(); ++n) {
    const auto [lower, upper] =
        std::minmax({numberOf(*found[n].m_pProxy0), numberOf(*found[n].m_pProxy1)});
    if (!isBall(upper)) (upper == kGround ? lists.nearGround : lists.nearWall).push_back(lower);
  }
  const auto forEachIn = [&](std::size_t, auto visit) {
    for (int n = 0; n < found.size(); ++n) {
      const std::uint32_t x = numberOf(*found[n].m_pProxy0);
      const std::uint32_t y = numberOf(*found[n].m_pProxy1);
      if (isBall(std::max(x, y))) visit(x, y);
    }
  };
  sorter_.sort(tree_->ofBall.size(), 1, threads, forEachIn, lists.ballPairs);
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
    proxy = tree_->broadphase.createProxy(fatLow, fatHigh, 0, asClient(ball), kBallGroup, kBallMask,
                                          nullptr);
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
    tree_ = std::make_unique<Tree>(tree_->ofBall.size(), tree_->arena);
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
  BallCollector collector(found);
  tree_->broadphase.aabbTest(toBullet(low), toBullet(high), collector);
}

}  // namespace wells
