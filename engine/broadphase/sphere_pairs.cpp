#include "broadphase/sphere_pairs.h"

#include <algorithm>
#include <cmath>

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
constexpr std::uint32_t kRange = 1024;  // slots that are searched at a time

bool overlap(const BoundSphere& x, const BoundSphere& y) {
  const double bound = x.radius + y.radius;
  return squaredLength(y.center - x.center) <= bound * bound;
}

bool isFiniteBall(const World& world, std::span<const double> reach, std::uint32_t ball) {
  return isFinite(world.balls.position[ball]) && std::isfinite(reach[ball]);
}

}  // namespace

std::int64_t SpherePairs::update(const World& world, std::span<const double> reach,
                                 std::span<const std::uint32_t> among, ThreadPool& threads,
                                 std::vector<BallPair>& pairs) {
  if (areKnown(world, reach, among)) {
    ++stepsServed_;
    areReaches_ = false;
    if (removed_ > 0)
      std::erase_if(pairs,
                    [&](const BallPair& pair) { return !isThere(pair.a) || !isThere(pair.b); });
    return static_cast<std::int64_t>(std::exchange(removed_, 0));
  }
  setSpheres(world, reach, among, pairs.size());
  search(threads);
  list(threads, pairs);
  removed_ = 0;
  return static_cast<std::int64_t>(among.size());
}

void SpherePairs::remove(std::span<const std::uint32_t> balls) {
  for (const std::uint32_t i : balls) spheres_[i].radius = kAbsent;
  removed_ += balls.size();
}

void SpherePairs::findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found) {
  grid_.findIn(low, high, near_);
  for (const std::uint32_t slot : near_)
    if (const std::uint32_t i = grid_.boxOf()[slot]; isThere(i)) found.push_back(i);
  for (const std::uint32_t i : grid_.large())
    if (isThere(i)) found.push_back(i);
}

/// Whether no pair of these balls can be missing.
bool SpherePairs::areKnown(const World& world, std::span<const double> reach,
                           std::span<const std::uint32_t> among) const {
  return std::ranges::all_of(among, [&](std::uint32_t i) {
    if (!isFiniteBall(world, reach, i)) return !isThere(i);
    const auto& [center, radius] = spheres_[i];
    const double margin = radius - (world.balls.radius[i] + reach[i]);
    return margin >= 0 && squaredLength(world.balls.position[i] - center) <= margin * margin;
  });
}

/// The present list has so many `pairs`.
void SpherePairs::setSpheres(const World& world, std::span<const double> reach,
                             std::span<const std::uint32_t> among, std::size_t pairs) {
  const Balls& balls = world.balls;
  const double skinTime = kSkinSteps * world.settings.dt;
  const auto setAll = [&](bool hasSkin) {
    double volume = 0;
    for (const std::uint32_t i : there_) {
      const double skin =
          hasSkin ? kSkin * balls.radius[i] + skinTime * length(balls.velocity[i]) : 0;
      const double radius = balls.radius[i] + reach[i] + skin;
      spheres_[i] = {balls.position[i], radius};
      volume += radius * radius * radius;
    }
    return volume;
  };
  there_.clear();
  for (const std::uint32_t i : among) {
    if (isFiniteBall(world, reach, i))
      there_.push_back(i);
    else
      spheres_[i].radius = kAbsent;
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
  grid_.sort(spheres_, there_, threads);
  found_.resize((grid_.slots() + kRange - 1) / kRange);
  threads.forRanges(found_.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
      findBalls({n * kRange, std::min((n + 1) * kRange, grid_.slots())}, found_[n]);
  });
  searchLarge();
}

/// Balls instead of slots; of what the grid finds in single precision those that overlap, unless
/// pairs are to be narrowed anyway.
void SpherePairs::findBalls(SlotRange range, FoundPartners& found) const {
  grid_.find(range, found);
  const std::uint32_t* const ball = grid_.boxOf().data();
  std::uint32_t from = 0;
  std::uint32_t count = 0;
  for (std::uint32_t slot = range.begin; slot < range.end; ++slot) {
    const BoundSphere& sphere = spheres_[ball[slot]];
    std::uint32_t& end = found.ends[slot - range.begin];
    for (; from < end; ++from) {
      const std::uint32_t partner = ball[found.partners[from]];
      found.partners[count] = partner;
      count += !areReaches_ || overlap(sphere, spheres_[partner]) ? 1 : 0;
    }
    end = count;
  }
}

void SpherePairs::searchLarge() {
  largePairs_.clear();
  const auto large = grid_.large();
  for (std::size_t n = 0; n < large.size(); ++n) {
    const BoundSphere& sphere = spheres_[large[n]];
    const Vec3 half = Vec3::Constant(sphere.radius);
    grid_.findIn(sphere.center - half, sphere.center + half, near_);
    for (const std::uint32_t slot : near_)
      if (const std::uint32_t i = grid_.boxOf()[slot]; overlap(sphere, spheres_[i]))
        largePairs_.push_back({large[n], i});
    for (const std::uint32_t i : large.first(n))
      if (overlap(sphere, spheres_[i])) largePairs_.push_back({large[n], i});
  }
}

void SpherePairs::list(ThreadPool& threads, std::vector<BallPair>& pairs) {
  const auto ball = grid_.boxOf();
  const auto forEachIn = [&](std::size_t range, auto visit) {
    if (range == found_.size())
      for (const auto& [x, y] : largePairs_) visit(x, y);
    else
      found_[range].forEachPair([&](std::uint32_t slot, std::uint32_t y) { visit(ball[slot], y); });
  };
  sorter_.sort(spheres_.size(), found_.size() + 1, threads, forEachIn, pairs);
}

}  // namespace wells
