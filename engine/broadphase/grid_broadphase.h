// Bullet's broadphase interface over a uniform grid (cell_grid.h), for many boxes of about the same
// size. All pairs are found anew whenever a box has changed.
//
// With a pair cache it serves any Bullet world. Without one it keeps a flat list of what it finds,
// for whoever wants pairs and no algorithms that hang on them.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "broadphase/cell_grid.h"
#include "threads/thread_pool.h"

namespace wells {

class GridBroadphase final : public btBroadphaseInterface {
 public:
  /// `cache` outlives this. It gets every pair whose boxes overlap and which its filter lets pass,
  /// and loses all others; it must not put off removals (btHashedOverlappingPairCache does not).
  /// Null: see forEachPair().
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

  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

  /// Whose threads search, until another is set; must outlive that. Null: the caller's alone.
  void setThreads(ThreadPool* threads) { threads_ = threads; }

  btOverlappingPairCache* getOverlappingPairCache() override { return cache_; }
  const btOverlappingPairCache* getOverlappingPairCache() const override { return cache_; }
  void getBroadphaseAabb(btVector3& low, btVector3& high) const override;
  void printStats() override;

  /// At most so many.
  std::size_t pairs() const;

  /// Calls inCells(x, y) or large(x, y) for the pairs of the last calculateOverlappingPairs(), each
  /// once, in no particular order: all whose boxes overlap and which may collide, and some whose
  /// boxes nearly overlap. x and y are the proxies' client objects, which must be numbers of 32
  /// bits. In large pairs, one box is much larger than most boxes, or very far away.
  template <class InCells, class Large>
  void forEachPair(InCells inCells, Large large) const {
    if (needsFilter_)
      forEachPairOfSlots([&](std::uint32_t x, std::uint32_t y) {
        if (mayCollide(*proxyIn(x), *proxyIn(y))) inCells(numberIn_[x], numberIn_[y]);
      });
    else
      forEachPairOfSlots(
          [&](std::uint32_t x, std::uint32_t y) { inCells(numberIn_[x], numberIn_[y]); });
    for (const auto& [x, y] : largePairs_) large(numberOf(*x), numberOf(*y));
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
  static std::uint32_t numberOf(const btBroadphaseProxy& proxy) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject));
  }
  btBroadphaseProxy* proxyIn(std::uint32_t slot) const { return proxies_[grid_.boxOf()[slot]]; }

  template <class Visit>
  void forEachPairOfSlots(Visit visit) const {
    for (const FoundPartners& found : found_) {
      const std::uint32_t* at = found.partners.data();
      for (std::uint32_t slot = found.slots.begin; slot < found.slots.end; ++slot)
        for (const auto* const end = found.partners.data() + found.ends[slot - found.slots.begin];
             at < end; ++at)
          visit(slot, *at);
    }
  }

  void search();
  void lookAtSlots();
  void searchLarge();
  void fillCache(btDispatcher* dispatcher);

  ThreadPool* threads_ = nullptr;
  btNullPairCache noCache_;
  btOverlappingPairCache* cache_;  // never null
  std::deque<Proxy> pool_;
  std::vector<Proxy*> unused_;
  std::vector<btBroadphaseProxy*> proxies_;
  int lastId_ = 0;
  bool areOld_ = false;  // the pairs: a box has changed since they were found
  CellGrid grid_;
  // Of the last search.
  std::vector<FoundPartners> found_;
  std::vector<ProxyPair> largePairs_;
  std::vector<std::uint32_t> numberIn_;  // by slot
  bool needsFilter_ = false;             // not all that have slots collide with each other
  std::vector<std::uint32_t> near_;      // scratch
};

}  // namespace wells
