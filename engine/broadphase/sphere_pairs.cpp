#include "broadphase/sphere_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "broadphase/arena_boxes.h"
#include "broadphase/ball_collector.h"

namespace wells {
namespace {

// The skin: radii of the ball, and steps of its motion. A list that serves few steps is not worth
// the pairs that the skin adds: after one that did not, none has a skin for a while. 10,000 balls,
// ms a step without and with skin: T1 after 200 steps 1.3 and 0.6, T2 1.0 and 0.4; T1 after 60
// steps, where all fly and are hit, 1.1 and 1.7.
constexpr double kSkin = 0.4;
constexpr double kSkinSteps = 4;
constexpr int kFewSteps = 3;
constexpr int kListsWithoutSkin = 30;
// Nor is it worth more pairs than so many a ball: T1 with 100,000 balls, all of which fly after 30
// steps, had 32 in the step that tried a skin, and 5 without, and that step took three times as
// long. With 10,000 after 100 steps 20 cost less than a new list in each step.
constexpr double kMostPairsWithSkin = 24;
constexpr std::size_t kLeastRange = 4096;  // balls, that a thread looks at

bool isFiniteBall(const World& world, std::span<const double> reach, std::uint32_t ball) {
  return isFinite(world.balls.position[ball]) && std::isfinite(reach[ball]);
}

}  // namespace

// Those with ground and wall stay: the grid takes its proxies with it.
SpherePairs::SpherePairs(std::size_t balls, const Arena& arena)
    : spheres_(balls), proxies_(balls, nullptr) {
  addArena(arena, grid_);
}

std::int64_t SpherePairs::update(const World& world, std::span<const double> reach,
                                 std::span<const std::uint32_t> among, ThreadPool& threads,
                                 CandidateLists& lists) {
  if (areKnown(world, reach, among, threads)) {
    ++stepsServed_;
    areReaches_ = false;
    if (removed_ > 0) forget(lists);
    return static_cast<std::int64_t>(std::exchange(removed_, 0));
  }
  setSpheres(world, reach, among, lists.ballPairs.size(), threads);
  search(threads);
  list(threads, lists);
  removed_ = 0;
  return static_cast<std::int64_t>(among.size());
}

void SpherePairs::remove(std::span<const std::uint32_t> balls) {
  for (const std::uint32_t i : balls) removeSphere(i);
  removed_ += balls.size();
}

void SpherePairs::removeSphere(std::uint32_t ball) {
  btBroadphaseProxy*& proxy = proxies_[ball];
  if (proxy) grid_.destroyProxy(std::exchange(proxy, nullptr), nullptr);
}

/// Balls that are gone.
void SpherePairs::forget(CandidateLists& lists) const {
  std::erase_if(lists.ballPairs,
                [&](const BallPair& pair) { return !isThere(pair.a) || !isThere(pair.b); });
  for (auto* list : {&lists.nearGround, &lists.nearWall})
    std::erase_if(*list, [&](std::uint32_t ball) { return !isThere(ball); });
}

void SpherePairs::findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found) {
  BallCollector collector(found);
  grid_.aabbTest(toBullet(low), toBullet(high), collector);
}

/// Whether no pair of these balls can be missing.
bool SpherePairs::areKnown(const World& world, std::span<const double> reach,
                           std::span<const std::uint32_t> among, ThreadPool& threads) const {
  const auto isKnown = [&](std::uint32_t i) {
    if (!isFiniteBall(world, reach, i)) return !isThere(i);
    const BoundSphere& sphere = spheres_[i];
    const double margin = sphere.radius - (world.balls.radius[i] + reach[i]);
    return isThere(i) && margin >= 0 &&
           squaredLength(world.balls.position[i] - sphere.center) <= margin * margin;
  };
  std::array<bool, kMostThreads> areUnknown{};
  threads.forRanges(
      among.size(), kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t range) {
        areUnknown[range] = !std::ranges::all_of(among.subspan(begin, end - begin), isKnown);
      });
  return std::ranges::none_of(areUnknown, std::identity());
}

/// The present list has so many `pairs`.
void SpherePairs::setSpheres(const World& world, std::span<const double> reach,
                             std::span<const std::uint32_t> among, std::size_t pairs,
                             ThreadPool& threads) {
  const Balls& balls = world.balls;
  const double skinTime = kSkinSteps * world.settings.dt;
  const auto setAll = [&](bool hasSkin) {
    threads.forRanges(
        there_.size(), kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t) {
          for (const std::uint32_t i : std::span(there_).subspan(begin, end - begin)) {
            const double skin =
                hasSkin ? kSkin * balls.radius[i] + skinTime * length(balls.velocity[i]) : 0;
            spheres_[i] = {balls.position[i], balls.radius[i] + reach[i] + skin};
          }
        });
    // In one order, for any number of threads.
    double volume = 0;
    for (const std::uint32_t i : there_) {
      const double radius = spheres_[i].radius;
      volume += radius * radius * radius;
    }
    return volume;
  };
  there_.clear();
  for (const std::uint32_t i : among) {
    if (isFiniteBall(world, reach, i))
      there_.push_back(i);
    else
      removeSphere(i);
  }
  const double before = volume_;
  areReaches_ = !nextHasSkin();
  if (!areReaches_) {
    volume_ = setAll(true);
    // About as many pairs a volume as there were.
    const double most = kMostPairsWithSkin * static_cast<double>(there_.size());
    if (static_cast<double>(pairs) * volume_ <= most * before) return;
  }
  areReaches_ = true;
  volume_ = setAll(false);
}

/// Whether the list that is made next is to serve several steps.
bool SpherePairs::nextHasSkin() {
  if (listsWithoutSkin_ > 0)
    --listsWithoutSkin_;
  else if (volume_ > 0 && stepsServed_ < kFewSteps)
    listsWithoutSkin_ = kListsWithoutSkin;
  stepsServed_ = 1;
  return listsWithoutSkin_ == 0;
}

void SpherePairs::search(ThreadPool& threads) {
  const btVector3 unset(0, 0, 0);
  for (const std::uint32_t i : there_)
    if (btBroadphaseProxy*& proxy = proxies_[i]; !proxy)
      proxy = grid_.createProxy(unset, unset, 0, asClient(i), kBallGroup, kBallMask, nullptr);
  threads.forRanges(there_.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t) {
                      for (const std::uint32_t i : std::span(there_).subspan(begin, end - begin)) {
                        const Vec3 half = Vec3::Constant(spheres_[i].radius);
                        proxies_[i]->m_aabbMin = toBullet(spheres_[i].center - half);
                        proxies_[i]->m_aabbMax = toBullet(spheres_[i].center + half);
                      }
                    });
  grid_.setChanged();
  grid_.setThreads(&threads);
  grid_.calculateOverlappingPairs(nullptr);
  grid_.setThreads(nullptr);
}

// The grid compares in single precision, and asks where that does not decide. Pairs that are to be
// narrowed anyway may stay.
void SpherePairs::list(ThreadPool& threads, CandidateLists& lists) {
  const auto overlap = [&](std::uint32_t x, std::uint32_t y) {
    const double bound = spheres_[x].radius + spheres_[y].radius;
    return squaredLength(spheres_[y].center - spheres_[x].center) <= bound * bound;
  };
  grid_.setThreads(&threads);
  if (areReaches_) grid_.narrow(overlap);
  grid_.setThreads(nullptr);
  lists.nearGround.clear();
  lists.nearWall.clear();
  const std::size_t large = grid_.ranges() - 1;
  grid_.forEachPairIn(large, [&](std::uint32_t x, std::uint32_t y) {
    const std::uint32_t upper = std::max(x, y);
    if (!isBall(upper))
      (upper == kGround ? lists.nearGround : lists.nearWall).push_back(std::min(x, y));
  });
  sorter_.sort(
      spheres_.size(), grid_.ranges(), threads,
      [&](std::size_t range, auto visit) {
        grid_.forEachPairIn(range, [&](std::uint32_t x, std::uint32_t y) {
          // Ground and wall are in no cell.
          if (range < large || (isBall(std::max(x, y)) && overlap(x, y))) visit(x, y);
        });
      },
      lists.ballPairs);
}

}  // namespace wells
