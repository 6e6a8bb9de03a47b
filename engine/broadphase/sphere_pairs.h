// Which balls may touch what, by a grid behind Bullet's interface (grid_broadphase.h): those whose
// spheres overlap. A sphere holds the ball wherever it may get in the step, and a skin, so that one
// list of pairs serves several steps; when one ball leaves its sphere, all are set anew. For balls
// of about the same size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "broadphase/grid_broadphase.h"
#include "state/world.h"
#include "threads/thread_pool.h"

namespace wells {

class SpherePairs {
 public:
  SpherePairs(std::size_t balls, const Arena& arena);

  /// As Broadphase::update() has it. Returns how many spheres were set or removed.
  std::int64_t update(const World& world, std::span<const double> reach,
                      std::span<const std::uint32_t> among, ThreadPool& threads,
                      CandidateLists& lists);

  /// As Broadphase::areNear() has it.
  bool areNear() const { return areReaches_; }

  void remove(std::span<const std::uint32_t> balls);

  /// As Broadphase::findIn() has it.
  void findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found);

 private:
  struct BoundSphere {
    Vec3 center = Vec3::Zero();  // m
    double radius = 0;           // m
  };

  bool isThere(std::uint32_t ball) const { return proxies_[ball] != nullptr; }
  bool areKnown(const World& world, std::span<const double> reach,
                std::span<const std::uint32_t> among, ThreadPool& threads) const;
  void setSpheres(const World& world, std::span<const double> reach,
                  std::span<const std::uint32_t> among, std::size_t pairs, ThreadPool& threads);
  void removeSphere(std::uint32_t ball);
  bool nextHasSkin();
  void search(ThreadPool& threads);
  void list(ThreadPool& threads, CandidateLists& lists);
  void forget(CandidateLists& lists) const;

  GridBroadphase grid_{nullptr, BoxContent::Spheres};
  std::vector<BoundSphere> spheres_;         // by ball
  std::vector<btBroadphaseProxy*> proxies_;  // by ball; null: it is in no pair
  bool areReaches_ = false;                  // of the last update, no larger
  std::size_t removed_ = 0;                  // since the pairs were listed
  int stepsServed_ = 0;                      // by the present list
  int listsWithoutSkin_ = 0;                 // that are to follow
  double volume_ = 0;                        // m^3, of the cubes of its radii; 0: there is none
  PairSorter sorter_;
  std::vector<std::uint32_t> there_;  // scratch
};

}  // namespace wells
