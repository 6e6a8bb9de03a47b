#include "broadphase/broadphase.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

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
constexpr int kWallPieces = 64;
// Each ball that is removed costs a look at all pairs; of more at once, those that stay are built
// afresh.
constexpr std::size_t kMostRemoved = 16;
constexpr double kFarAway = 1e15;  // m; beyond any arena, and still exact enough to sort

// What a proxy stands for, kept in Bullet's user pointer.
enum Partner : std::intptr_t { kGroundProxy = -1, kWallProxy = -2 };

std::intptr_t partnerOf(const btBroadphaseProxy* proxy) {
  return reinterpret_cast<std::intptr_t>(proxy->m_clientObject);
}

btVector3 toBullet(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

struct Broadphase::Bullet {
  btDbvtBroadphase broadphase;
  std::vector<btBroadphaseProxy*> proxies;  // by ball; null: not finite, in no pair
  std::vector<btBroadphaseProxy*> arenaProxies;
  std::vector<double> radius;  // m, by ball, of its proxy
  Arena arena;

  Bullet() = default;
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;

  // Bullet leaves proxies to whoever created them. The pairs go first, because each proxy would
  // search all of them for its own.
  ~Bullet() {
    broadphase.getOverlappingPairCache()->getOverlappingPairArray().clear();
    for (auto* const proxy : arenaProxies) broadphase.destroyProxy(proxy, nullptr);
    for (auto* const proxy : proxies)
      if (proxy) broadphase.destroyProxy(proxy, nullptr);
  }

  btBroadphaseProxy* add(const Vec3& low, const Vec3& high, std::intptr_t partner) {
    // Ground and wall (group 2) pair with balls (group 1) only.
    const int group = partner < 0 ? 2 : 1;
    const int mask = partner < 0 ? 1 : 3;
    return broadphase.createProxy(toBullet(low), toBullet(high), 0,
                                  reinterpret_cast<void*>(partner), group, mask, nullptr);
  }

  void addArena() {
    const Vec3 c = arena.center;
    arenaProxies.push_back(add({c.x() - kFarAway, c.y() - kFarAway, c.z() - kFarAway},
                               {c.x() + kFarAway, c.y(), c.z() + kFarAway}, kGroundProxy));
    // Each piece covers everything beyond the wall in its sector as well, so that a ball cannot
    // pass it by in one step.
    const double inner = arena.radius;
    const double outer = kFarAway;
    for (int piece = 0; piece < kWallPieces; ++piece) {
      const SinCos from = sinCosOfTurns(static_cast<double>(piece) / kWallPieces);
      const SinCos to = sinCosOfTurns(static_cast<double>(piece + 1) / kWallPieces);
      Vec3 low{kFarAway, -kFarAway, kFarAway};
      Vec3 high{-kFarAway, kFarAway, -kFarAway};
      for (const SinCos& edge : {from, to})
        for (const double r : {inner, outer}) {
          low.x() = std::min(low.x(), r * edge.cos);
          low.z() = std::min(low.z(), r * edge.sin);
          high.x() = std::max(high.x(), r * edge.cos);
          high.z() = std::max(high.z(), r * edge.sin);
        }
      // Multiples of a quarter turn are edges of pieces, so the corners bound the arc itself.
      arenaProxies.push_back(add(c + low, c + high, kWallProxy));
    }
  }
};

Broadphase::Broadphase() = default;
Broadphase::~Broadphase() = default;

void Broadphase::build(const World& world) {
  bullet_ = std::make_unique<Bullet>();
  bullet_->arena = world.arena;
  bullet_->broadphase.m_deferedcollide = true;  // one pass over the trees instead of one per proxy
  bullet_->addArena();
  bullet_->proxies.assign(world.balls.size(), nullptr);
  bullet_->radius.resize(world.balls.size());
  list();
}

bool Broadphase::isBuiltFor(const World& world, std::span<const std::uint32_t> among) const {
  return bullet_ && bullet_->proxies.size() == world.balls.size() &&
         bullet_->arena.center == world.arena.center &&
         bullet_->arena.radius == world.arena.radius && removed_ <= kMostRemoved &&
         std::ranges::all_of(among, [&](std::uint32_t i) {
           return !bullet_->proxies[i] || bullet_->radius[i] == world.balls.radius[i];
         });
}

void Broadphase::remove(std::span<const std::uint32_t> balls) {
  if (!bullet_) return;
  arePairsOld_ = true;
  removed_ += balls.size();
  if (removed_ > kMostRemoved) return;
  for (const std::uint32_t i : balls) removeProxy(i);
}

void Broadphase::removeProxy(std::uint32_t ball) {
  btBroadphaseProxy*& proxy = bullet_->proxies[ball];
  if (!proxy) return;
  bullet_->broadphase.destroyProxy(proxy, nullptr);
  proxy = nullptr;
  ++moved_;
}

void Broadphase::update(const World& world, std::span<const double> reach,
                        std::span<const std::uint32_t> among) {
  const Balls& balls = world.balls;
  if (!isBuiltFor(world, among)) build(world);
  removed_ = 0;
  moved_ = 0;
  for (const std::uint32_t i : among) {
    btBroadphaseProxy*& proxy = bullet_->proxies[i];
    if (!isFinite(balls.position[i]) || !std::isfinite(reach[i])) {
      removeProxy(i);
      continue;
    }
    const double half = balls.radius[i] + reach[i];
    const Vec3 swept = Vec3::Constant(half);
    const Vec3 fat = Vec3::Constant(half + kFattening * balls.radius[i]);
    const Vec3& x = balls.position[i];
    const Vec3 ahead = balls.velocity[i] * (kAhead * world.settings.dt);
    const Vec3 fatLow = x - fat + ahead.cwiseMin(0);
    const Vec3 fatHigh = x + fat + ahead.cwiseMax(0);
    if (!proxy) {
      proxy = bullet_->add(fatLow, fatHigh, static_cast<std::intptr_t>(i));
      bullet_->radius[i] = balls.radius[i];
      ++moved_;
      continue;
    }
    const btVector3 low = toBullet(x - swept);
    const btVector3 high = toBullet(x + swept);
    const bool inside = low.x() >= proxy->m_aabbMin.x() && high.x() <= proxy->m_aabbMax.x() &&
                        low.y() >= proxy->m_aabbMin.y() && high.y() <= proxy->m_aabbMax.y() &&
                        low.z() >= proxy->m_aabbMin.z() && high.z() <= proxy->m_aabbMax.z();
    if (inside) continue;
    bullet_->broadphase.setAabb(proxy, toBullet(fatLow), toBullet(fatHigh), nullptr);
    ++moved_;
  }
  // Boxes that stand where they stood have the pairs that they had.
  if (moved_ == 0 && !arePairsOld_) return;
  bullet_->broadphase.calculateOverlappingPairs(nullptr);
  list();
  arePairsOld_ = false;
}

void Broadphase::list() {
  ballPairs_.clear();
  nearGround_.clear();
  nearWall_.clear();
  const btBroadphasePairArray& pairs =
      bullet_->broadphase.getOverlappingPairCache()->getOverlappingPairArray();
  for (int n = 0; n < pairs.size(); ++n) {
    std::intptr_t first = partnerOf(pairs[n].m_pProxy0);
    std::intptr_t second = partnerOf(pairs[n].m_pProxy1);
    if (first > second) std::swap(first, second);
    const auto ball = static_cast<std::uint32_t>(second);
    if (first == kGroundProxy)
      nearGround_.push_back(ball);
    else if (first == kWallProxy)
      nearWall_.push_back(ball);
    else
      ballPairs_.push_back({static_cast<std::uint32_t>(first), ball});
  }
}

}  // namespace wells
