#include "world/late_pairs.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include "math/room.h"

namespace wells {
namespace {

constexpr std::uint32_t kNoStep = 0;

/// Never kNoStep, within the four thousand million steps after which it repeats.
std::uint32_t numberOf(std::int64_t step) {
  return static_cast<std::uint32_t>(step) + 1;
}

constexpr double kLateOverlap = 1e-6;       // of the sum of radii
constexpr std::size_t kLeastRange = 16384;  // pairs, that a thread looks at

}  // namespace

std::int64_t LatePairs::count(const World& world, std::span<const BallPair> pairs,
                              std::span<const Candidates::Sphere> start,
                              std::span<const std::uint32_t> awake, ThreadPool& threads) {
  nextStep_.resize(world.balls.size(), kNoStep);
  std::array<std::int64_t, kMostThreads> late{};
  threads.forRanges(pairs.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t range) {
                      late[range] = countIn({begin, end}, world, pairs, start);
                    });
  keep(pairs);
  for (const std::uint32_t i : awake) nextStep_[i] = numberOf(world.step + 1);
  return std::accumulate(late.begin(), late.end(), std::int64_t{0});
}

std::int64_t LatePairs::countIn(IndexRange range, const World& world,
                                std::span<const BallPair> pairs,
                                std::span<const Candidates::Sphere> start) const {
  if (range.begin == range.end) return 0;
  std::int64_t late = 0;
  std::uint32_t ball = kGround;
  std::uint32_t old = 0;
  std::uint32_t end = 0;
  auto list = std::ranges::lower_bound(lists_, pairs[range.begin].a, {}, &List::a);
  for (const BallPair& pair : pairs.subspan(range.begin, range.end - range.begin)) {
    if (pair.a != ball) {
      ball = pair.a;
      while (list != lists_.end() && list->a < ball) ++list;
      const bool isThere = list != lists_.end() && list->a == ball;
      old = isThere ? (list == lists_.begin() ? 0 : std::prev(list)->end) : 0;
      end = isThere ? list->end : 0;
    }
    while (old < end && partners_[old] < pair.b) ++old;
    if (old < end && partners_[old] == pair.b)
      ++old;  // so that the next is most often the one that is looked for
    else if (isLate(world, pair, start))
      ++late;
  }
  return late;
}

void LatePairs::keep(std::span<const BallPair> pairs) {
  resizeAfresh(partners_, pairs.size());
  lists_.clear();
  for (std::uint32_t n = 0; n < pairs.size(); ++n) {
    partners_[n] = pairs[n].b;
    if (n == 0 || pairs[n].a != pairs[n - 1].a) lists_.push_back({pairs[n].a, n});
    lists_.back().end = n + 1;
  }
}

bool LatePairs::isLate(const World& world, const BallPair& pair,
                       std::span<const Candidates::Sphere> start) const {
  const auto [a, b] = pair;
  const double most = (1 - kLateOverlap) * (world.balls.radius[a] + world.balls.radius[b]);
  return squaredLength(start[b].center - start[a].center) < most * most &&
         nextStep_[a] == numberOf(world.step) && nextStep_[b] == numberOf(world.step) &&
         world.owns(a) && world.owns(b);
}

}  // namespace wells
