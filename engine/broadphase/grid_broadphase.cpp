#include "broadphase/grid_broadphase.h"

#include <LinearMath/btAabbUtil2.h>
#include <fmt/format.h>

#include <algorithm>

namespace wells {
namespace {

constexpr std::uint32_t kRange = 1024;  // slots that are searched at a time

Vec3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Not so where a face is not a number; Bullet's own test says that those overlap with everything.
bool overlap(const btBroadphaseProxy& x, const btBroadphaseProxy& y) {
  bool all = true;
  for (int k = 0; k < 3; ++k)
    all &= x.m_aabbMin[k] <= y.m_aabbMax[k] && y.m_aabbMin[k] <= x.m_aabbMax[k];
  return all;
}

}  // namespace

GridBroadphase::GridBroadphase(btOverlappingPairCache* cache, BoxContent content)
    : cache_(cache ? cache : &noCache_), grid_(content) {}

btBroadphaseProxy* GridBroadphase::createProxy(const btVector3& low, const btVector3& high, int,
                                               void* client, int group, int mask, btDispatcher*) {
  Proxy* proxy = nullptr;
  if (unused_.empty()) {
    proxy = &pool_.emplace_back();
  } else {
    proxy = unused_.back();
    unused_.pop_back();
  }
  proxy->m_clientObject = client;
  proxy->m_collisionFilterGroup = group;
  proxy->m_collisionFilterMask = mask;
  proxy->m_uniqueId = ++lastId_;
  proxy->m_aabbMin = low;
  proxy->m_aabbMax = high;
  proxy->place = proxies_.size();
  proxies_.push_back(proxy);
  areOld_ = true;
  return proxy;
}

void GridBroadphase::destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) {
  cache_->removeOverlappingPairsContainingProxy(proxy, dispatcher);
  auto* const own = static_cast<Proxy*>(proxy);
  auto* const last = static_cast<Proxy*>(proxies_.back());
  last->place = own->place;
  proxies_[own->place] = last;
  proxies_.pop_back();
  unused_.push_back(own);
  areOld_ = true;
}

void GridBroadphase::setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
                             btDispatcher*) {
  proxy->m_aabbMin = low;
  proxy->m_aabbMax = high;
  areOld_ = true;
}

void GridBroadphase::getAabb(btBroadphaseProxy* proxy, btVector3& low, btVector3& high) const {
  low = proxy->m_aabbMin;
  high = proxy->m_aabbMax;
}

void GridBroadphase::rayTest(const btVector3& from, const btVector3&,
                             btBroadphaseRayCallback& callback, const btVector3& low,
                             const btVector3& high) {
  for (const btBroadphaseProxy* const proxy : proxies_) {
    // What travels along the ray has a size of its own.
    const btVector3 bounds[2] = {proxy->m_aabbMin - high, proxy->m_aabbMax - low};
    btScalar at = 1;
    if (btRayAabb2(from, callback.m_rayDirectionInverse, callback.m_signs, bounds, at, 0,
                   callback.m_lambda_max))
      callback.process(proxy);
  }
}

void GridBroadphase::aabbTest(const btVector3& low, const btVector3& high,
                              btBroadphaseAabbCallback& callback) {
  const auto test = [&](const btBroadphaseProxy* proxy) {
    if (TestAabbAgainstAabb2(low, high, proxy->m_aabbMin, proxy->m_aabbMax))
      callback.process(proxy);
  };
  if (areOld_) {
    for (const btBroadphaseProxy* const proxy : proxies_) test(proxy);
    return;
  }
  grid_.findIn(fromBullet(low), fromBullet(high), near_);
  for (const std::uint32_t slot : near_) test(proxyIn(slot));
  for (const std::uint32_t n : grid_.large()) test(proxies_[n]);
}

void GridBroadphase::calculateOverlappingPairs(btDispatcher* dispatcher) {
  if (!areOld_) return;
  areOld_ = false;
  search();
  if (cache_ != &noCache_) fillCache(dispatcher);
}

void GridBroadphase::search() {
  grid_.sort(proxies_, *threads_);
  numberIn_.resize(grid_.slots());
  found_.resize((grid_.slots() + kRange - 1) / kRange);
  threads_->forRanges(found_.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n) {
      const SlotRange range{n * kRange, std::min((n + 1) * kRange, grid_.slots())};
      for (std::uint32_t slot = range.begin; slot < range.end; ++slot)
        numberIn_[slot] = numberOf(*proxyIn(slot));
      grid_.find(range, found_[n]);
    }
  });
  searchLarge();
}

void GridBroadphase::searchLarge() {
  largePairs_.clear();
  int groups = 0;
  int masks = 0;
  for (const std::uint32_t n : grid_.large()) {
    groups |= proxies_[n]->m_collisionFilterGroup;
    masks |= proxies_[n]->m_collisionFilterMask;
  }
  const auto larges = grid_.large();
  for (std::size_t n = 0; n < larges.size(); ++n) {
    btBroadphaseProxy* const large = proxies_[larges[n]];
    grid_.findIn(fromBullet(large->m_aabbMin), fromBullet(large->m_aabbMax), near_);
    for (const std::uint32_t slot : near_)
      if (btBroadphaseProxy* const other = proxyIn(slot); mayCollide(*large, *other))
        largePairs_.emplace_back(large, other);
    // Walls and grounds are many, and do not collide with each other.
    if ((large->m_collisionFilterGroup & masks) == 0 ||
        (large->m_collisionFilterMask & groups) == 0)
      continue;
    for (std::size_t m = 0; m < n; ++m)
      if (btBroadphaseProxy* const other = proxies_[larges[m]];
          mayCollide(*large, *other) && overlap(*large, *other))
        largePairs_.emplace_back(large, other);
  }
}

void GridBroadphase::fillCache(btDispatcher* dispatcher) {
  const auto add = [&](btBroadphaseProxy* x, btBroadphaseProxy* y) {
    if (overlap(*x, *y)) cache_->addOverlappingPair(x, y);
  };
  for (const FoundPartners& found : found_)
    found.forEachPair([&](std::uint32_t x, std::uint32_t y) { add(proxyIn(x), proxyIn(y)); });
  for (const auto& [x, y] : largePairs_) add(x, y);
  // From the end: the cache fills the place of a pair that goes with the last.
  const btBroadphasePair* const pairs = cache_->getOverlappingPairArrayPtr();
  for (int n = cache_->getNumOverlappingPairs() - 1; n >= 0; --n)
    if (btBroadphaseProxy* const x = pairs[n].m_pProxy0, * const y = pairs[n].m_pProxy1;
        !overlap(*x, *y))
      cache_->removeOverlappingPair(x, y, dispatcher);
}

void GridBroadphase::getBroadphaseAabb(btVector3& low, btVector3& high) const {
  low.setValue(0, 0, 0);
  high.setValue(0, 0, 0);
  bool isFirst = true;
  for (const btBroadphaseProxy* const proxy : proxies_) {
    if (isFirst) {
      low = proxy->m_aabbMin;
      high = proxy->m_aabbMax;
      isFirst = false;
    }
    low.setMin(proxy->m_aabbMin);
    high.setMax(proxy->m_aabbMax);
  }
}

void GridBroadphase::printStats() {
  fmt::print("GridBroadphase: {} boxes, {} of them kept apart, {} cells\n", proxies_.size(),
             grid_.large().size(), grid_.cells());
}

}  // namespace wells
