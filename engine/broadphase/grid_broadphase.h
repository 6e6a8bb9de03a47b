// Bullet's broadphase interface over a uniform grid (cell_grid.h), for any Bullet world with many
// boxes of about the same size. All pairs are found anew whenever a box has changed.
//
// Our own worlds have no use for its proxies and its pair cache, see sphere_pairs.h.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "broadphase/cell_grid.h"

namespace wells {

class GridBroadphase final : public btBroadphaseInterface {
 public:
  /// `cache` outlives this. It gets every pair whose boxes overlap and which its filter lets pass,
  /// and loses all others; it must not put off removals (btHashedOverlappingPairCache does not).
  explicit GridBroadphase(btOverlappingPairCache* cache);

  btBroadphaseProxy* createProxy(const btVector3& low, const btVector3& high, int shape,
                                 void* client, int group, int mask,
                                 btDispatcher* dispatcher) override;
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;
  void setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
               btDispatcher* dispatcher) override;
  void getAabb(btBroadphaseProxy* proxy, btVector3& low, btVector3& high) const override;

  /// Hands over every box on the ray; O(boxes).
  void rayTest(const btVector3& from, const btVector3& to, btBroadphaseRayCallback& callback,
               const btVector3& low, const btVector3& high) override;
  /// Hands over every box that overlaps the given one. O(boxes / 64) and what is found, if no box
  /// has changed since the pairs were found.
  void aabbTest(const btVector3& low, const btVector3& high,
                btBroadphaseAabbCallback& callback) override;

  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

  btOverlappingPairCache* getOverlappingPairCache() override { return cache_; }
  const btOverlappingPairCache* getOverlappingPairCache() const override { return cache_; }
  void getBroadphaseAabb(btVector3& low, btVector3& high) const override;
  void printStats() override;

 private:
  struct Proxy : btBroadphaseProxy {
    std::size_t place = 0;  // in proxies_
  };
  using ProxyPair = std::pair<btBroadphaseProxy*, btBroadphaseProxy*>;

  static bool mayCollide(const btBroadphaseProxy& x, const btBroadphaseProxy& y) {
    return (x.m_collisionFilterGroup & y.m_collisionFilterMask) != 0 &&
           (y.m_collisionFilterGroup & x.m_collisionFilterMask) != 0;
  }
  btBroadphaseProxy* proxyIn(std::uint32_t slot) const { return proxies_[grid_.boxOf()[slot]]; }

  void search();
  void searchLarge();
  void fillCache(btDispatcher* dispatcher);

  btOverlappingPairCache* cache_;
  std::deque<Proxy> pool_;
  std::vector<Proxy*> unused_;
  std::vector<btBroadphaseProxy*> proxies_;
  int lastId_ = 0;
  bool areOld_ = false;  // the pairs: a box has changed since they were found
  CellGrid grid_{BoxContent::Anything};
  // Of the last search.
  FoundPartners found_;
  std::vector<ProxyPair> largePairs_;
  std::vector<std::uint32_t> near_;  // scratch
};

}  // namespace wells
