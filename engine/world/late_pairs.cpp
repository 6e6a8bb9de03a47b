#include "world/late_pairs.h"

#include <algorithm>

namespace wells {
namespace {

constexpr double kLateOverlap = 1e-6;  // of the sum of radii
constexpr std::int64_t kNoStep = -2;

}  // namespace

std::int64_t LatePairs::count(const World& world, std::span<const BallPair> pairs,
                              std::span<const BallState> start,
                              std::span<const std::uint32_t> awake) {
  lastStep_.resize(world.balls.size(), kNoStep);
  std::int64_t late = 0;
  auto old = before_.begin();
  const auto end = before_.end();
  for (const BallPair& pair : pairs) {
    while (old != end && (old->a != pair.a ? old->a < pair.a : old->b < pair.b)) ++old;
    if (old != end && *old == pair)
      ++old;  // so that the next is most often the one that is looked for
    else if (isLate(world, pair, start))
      ++late;
  }
  before_.resize(pairs.size());
  std::ranges::copy(pairs, before_.begin());
  for (const std::uint32_t i : awake) lastStep_[i] = world.step;
  return late;
}

bool LatePairs::isLate(const World& world, const BallPair& pair,
                       std::span<const BallState> start) const {
  const auto [a, b] = pair;
  if (lastStep_[a] + 1 != world.step || lastStep_[b] + 1 != world.step) return false;
  if (!world.owns(a) || !world.owns(b)) return false;
  const double touching = world.balls.radius[a] + world.balls.radius[b];
  const double apart = length(start[b].position - start[a].position);
  return apart - touching < -kLateOverlap * touching;
}

}  // namespace wells
