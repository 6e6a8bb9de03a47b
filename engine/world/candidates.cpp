#include "world/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/contact.h"
#include "math/room.h"
#include "math/straight_path.h"
#include "world/advance.h"
#include "world/pairs_of_few.h"

namespace wells {
namespace {

constexpr std::size_t kLeastRange = 4096;  // balls or pairs, that a thread looks at

// Of Candidates::nearArena_.
constexpr std::uint8_t kNearGround = 1;
constexpr std::uint8_t kNearWall = 2;

/// Fills the list with what find(n, place) puts there, up to `most` pairs for each n < count, whose
/// number it returns; without a branch for each, because whether a pair is near cannot be foretold.
template <class Find>
void collect(std::size_t count, ThreadPool& threads, std::size_t most, std::vector<BallPair>& list,
             Find find) {
  std::array<IndexRange, kMostThreads> found;
  threads.forRanges(count, kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t range) {
    BallPair* const first = list.data() + most * begin;
    BallPair* last = first;
    for (std::size_t n = begin; n < end; ++n) last += find(n, last);
    found[range] = {most * begin, static_cast<std::size_t>(last - list.data())};
  });
  // What the ranges found stands with gaps between.
  std::size_t size = 0;
  for (std::size_t range = 0; range < threads.ranges(count, kLeastRange); ++range) {
    const auto [begin, end] = found[range];
    std::copy(list.begin() + begin, list.begin() + end, list.begin() + size);
    size += end - begin;
  }
  list.resize(size);
}

}  // namespace

void Candidates::find(const World& world, std::span<const double> reach,
                      std::span<const std::uint32_t> among, ThreadPool& threads) {
  const Balls& balls = world.balls;
  spheres_.resize(balls.size());
  isLeaning_.resize(balls.size());
  threads.forRanges(among.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t) {
                      for (const std::uint32_t i : among.subspan(begin, end - begin)) {
                        isLeaning_[i] = 0;
                        spheres_[i] = {balls.position[i], balls.radius[i] + reach[i]};
                      }
                    });
  leaningPairs_.clear();
  areFew_ = among.size() <= FewSpheres::kMost && world.roles.empty() &&
            world.settings.broadphase == BroadphaseKind::Auto;
  areBroadphases_ = false;
  if (areFew_) return findAmongFew(world, reach, among);
  broadphase_.update(world, reach, among, &threads);
  areBroadphases_ = world.roles.empty() && broadphase_.areNear();
  if (!world.roles.empty())
    findBallsAndLeaning(world);
  else if (!areBroadphases_)
    findBalls(threads);
  findArena(world, reach, among, threads);
}

std::int64_t Candidates::pairs() const {
  if (areFew_) return static_cast<std::int64_t>(ballPairs_.size() + arenaPairs_.size());
  return static_cast<std::int64_t>(broadphase_.ballPairs().size() +
                                   broadphase_.nearGround().size() + broadphase_.nearWall().size());
}

void Candidates::findBalls(ThreadPool& threads) {
  const std::vector<BallPair>& pairs = broadphase_.ballPairs();
  resizeAfresh(ballPairs_, pairs.size());
  collect(pairs.size(), threads, 1, ballPairs_, [&](std::size_t n, BallPair* found) {
    const Sphere& a = spheres_[pairs[n].a];
    const Sphere& b = spheres_[pairs[n].b];
    const double bound = a.radius + b.radius;
    *found = pairs[n];
    return squaredLength(b.center - a.center) <= bound * bound ? std::size_t{1} : 0;
  });
}

std::span<const std::uint32_t> Candidates::findSurprised(const World& world,
                                                         std::span<const double> reach,
                                                         std::span<const std::uint32_t> among,
                                                         ThreadPool& threads) {
  findBeyond(world, reach, among, threads);
  double excess = 0;
  for (const auto& beyond : beyond_)
    for (const std::uint32_t i : beyond)
      excess = std::max(excess, length(wayOf(world, i)) - reach[i]);
  surprised_.clear();
  for (const auto& beyond : beyond_)
    for (const std::uint32_t i : beyond)
      if (isSurprised(world, among, i, reach[i], excess)) surprised_.push_back(i);
  return surprised_;
}

void Candidates::findBeyond(const World& world, std::span<const double> reach,
                            std::span<const std::uint32_t> among, ThreadPool& threads) {
  beyond_.resize(threads.ranges(among.size(), kLeastRange));
  threads.forRanges(among.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t range) {
                      beyond_[range].clear();
                      for (const std::uint32_t i : among.subspan(begin, end - begin)) {
                        // What is not finite has no reach.
                        if (squaredLength(wayOf(world, i)) > reach[i] * reach[i])
                          beyond_[range].push_back(i);
                      }
                    });
}

bool Candidates::isSurprised(const World& world, std::span<const std::uint32_t> among,
                             std::uint32_t ball, double reach, double excess) {
  const Balls& balls = world.balls;
  const auto [start, listed] = spheres_[ball];
  const Vec3 way = wayOf(world, ball);
  const double radius = balls.radius[ball];
  if (hasMissedArena(world.arena, start, balls.position[ball], radius, reach)) return true;
  if (!areFew_) {
    const Vec3 margin = Vec3::Constant(radius + length(way) + excess);
    around_.clear();
    broadphase_.findIn(start - margin, start + margin, around_);
    among = around_;
  }
  return std::ranges::any_of(among, [&](std::uint32_t i) {
    const Vec3 between = spheres_[i].center - start;
    const double bound = listed + spheres_[i].radius;
    return i != ball && squaredLength(between) > bound * bound &&
           distanceFromPath(between, Vec3::Zero(), way - wayOf(world, i)) <=
               radius + balls.radius[i];
  });
}

void Candidates::findAmongFew(const World& world, std::span<const double> reach,
                              std::span<const std::uint32_t> among) {
  FewSpheres spheres;
  arenaPairs_.clear();
  for (const std::uint32_t i : among) {
    const auto& [center, radius] = spheres_[i];
    spheres.add(i, center, radius);
    if (!std::isfinite(reach[i])) continue;
    for (const std::uint32_t partner : {kWall, kGround})
      if (mayTouchArena(world.arena, center, world.balls.radius[i], reach[i], partner))
        arenaPairs_.push_back({i, partner});
  }
  findPairsOfFew(spheres, ballPairs_);
}

void Candidates::findBallsAndLeaning(const World& world) {
  const Balls& balls = world.balls;
  ballPairs_.clear();
  for (const BallPair& pair : broadphase_.ballPairs()) {
    const auto [a, b] = pair;
    const double squared = squaredLength(spheres_[b].center - spheres_[a].center);
    if (world.owns(a) || world.owns(b)) {
      const double bound = spheres_[a].radius + spheres_[b].radius;
      if (squared <= bound * bound) ballPairs_.push_back(pair);
      continue;
    }
    const double leaning = (balls.radius[a] + balls.radius[b]) * (1 + kLeaningGap);
    if (squared >= leaning * leaning) continue;
    isLeaning_[a] = isLeaning_[b] = 1;
    leaningPairs_.push_back(pair);
  }
}

void Candidates::findArena(const World& world, std::span<const double> reach,
                           std::span<const std::uint32_t> among, ThreadPool& threads) {
  nearArena_.resize(world.balls.size());
  for (const std::uint32_t i : among) nearArena_[i] = 0;
  for (const std::uint32_t i : broadphase_.nearGround()) nearArena_[i] |= kNearGround;
  // A ball near two pieces of the wall stands twice.
  for (const std::uint32_t i : broadphase_.nearWall()) nearArena_[i] |= kNearWall;
  static_assert(kWall < kGround, "pairs are in order of (a, b)");
  resizeAfresh(arenaPairs_, 2 * among.size());
  collect(among.size(), threads, 2, arenaPairs_, [&](std::size_t n, BallPair* found) {
    const std::uint32_t i = among[n];
    const auto mayTouch = [&](std::uint8_t near, std::uint32_t partner) {
      return (nearArena_[i] & near) != 0 && mayTouchArena(world.arena, world.balls.position[i],
                                                          world.balls.radius[i], reach[i], partner);
    };
    found[0] = {i, kWall};
    const std::size_t walls = mayTouch(kNearWall, kWall) ? 1 : 0;
    found[walls] = {i, kGround};
    return walls + (mayTouch(kNearGround, kGround) ? 1 : 0);
  });
}

}  // namespace wells
