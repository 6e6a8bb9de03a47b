// Bullet's broadphase interface over a uniform grid (cell_grid.h), for many boxes of about the same
// size. All pairs are found anew whenever a box has changed.
//
// Bullet's own worlds take the pairs from a cache, which costs a look-up for each of them. Who
// needs none may do without the cache and go through what was found (sphere_pairs.h).
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "broadphase/bullet_proxy.h"
#include "broadphase/cell_grid.h"

namespace wells {

class GridBroadphase final : public btBroadphaseInterface {
 public:
  /// `cache` outlives this. It gets every pair whose boxes overlap and which its filter lets pass,
  /// and loses all others; it must not put off removals (btHashedOverlappingPairCache does not).
  /// Null: pairs are only to be had by narrow() and forEachPairIn().
  explicit GridBroadphase(btOverlappingPairCache* cache, BoxContent content = BoxContent::Anything);

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

  /// As if setAabb() had been called for proxies whose faces somebody has set.
  void setChanged() { areOld_ = true; }

  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

  /// Whose threads search, until another is set; must outlive that. Null: the caller's alone.
  void setThreads(ThreadPool* threads) { threads_ = threads ? threads : &alone_; }

  btOverlappingPairCache* getOverlappingPairCache() override { return cache_; }
  const btOverlappingPairCache* getOverlappingPairCache() const override { return cache_; }
  void getBroadphaseAabb(btVector3& low, btVector3& high) const override;
  void printStats() override;

  // What the last calculateOverlappingPairs() found, without filters: each pair whose boxes overlap
  // once, and some whose boxes nearly do. x and y are what proxies stand for (bullet_proxy.h).

  /// Drops pairs of boxes in cells for which !keep(x, y), which any thread may call. Others are
  /// those with boxes much larger than most, or very far away. Spheres that overlap for certain may
  /// stay unasked.
  template <class Keep>
  void narrow(Keep keep) {
    threads_->forRanges(found_.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t n = begin; n < end; ++n)
        found_[n].narrow([&](std::uint32_t slot, std::uint32_t partner) {
          return keep(numberIn_[slot], numberIn_[partner]);
        });
    });
  }

  /// Ranges of pairs, independent of each other; the last is of those with large boxes.
  std::size_t ranges() const { return found_.size() + 1; }
  /// Calls visit(x, y).
  template <class Visit>
  void forEachPairIn(std::size_t range, Visit visit) const {
    if (range < found_.size())
      found_[range].forEachPair(
          [&](std::uint32_t x, std::uint32_t y) { visit(numberIn_[x], numberIn_[y]); });
    else
      for (const auto& [x, y] : largePairs_) visit(numberOf(*x), numberOf(*y));
  }

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

  ThreadPool alone_;
  ThreadPool* threads_ = &alone_;
  btNullPairCache noCache_;
  btOverlappingPairCache* cache_;  // never null
  std::deque<Proxy> pool_;
  std::vector<Proxy*> unused_;
  std::vector<btBroadphaseProxy*> proxies_;
  int lastId_ = 0;
  bool areOld_ = false;  // the pairs: a box has changed since they were found
  CellGrid grid_;
  // Of the last search.
  std::vector<FoundPartners> found_;     // by range of slots
  std::vector<std::uint32_t> numberIn_;  // by slot
  std::vector<ProxyPair> largePairs_;
  std::vector<std::uint32_t> near_;  // scratch
};

}  // namespace wells
