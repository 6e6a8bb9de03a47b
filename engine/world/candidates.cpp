#include "world/candidates.h"

#include <algorithm>

#include "world/advance.h"

namespace wells {

void Candidates::find(const World& world, std::span<const double> reach,
                      std::span<const std::uint32_t> among, std::vector<BallPair>& balls,
                      std::vector<BallPair>& arena) {
  isLeaning_.resize(world.balls.size());
  for (const std::uint32_t i : among) isLeaning_[i] = 0;
  broadphase_.update(world, reach, among);
  findBalls(world, reach, balls);
  findArena(world, reach, arena);
}

std::int64_t Candidates::pairs() const {
  return static_cast<std::int64_t>(broadphase_.ballPairs().size() +
                                   broadphase_.nearGround().size() + broadphase_.nearWall().size());
}

void Candidates::findBalls(const World& world, std::span<const double> reach,
                           std::vector<BallPair>& contacts) {
  const Balls& balls = world.balls;
  contacts.clear();
  sorted_.clear();
  leaning_.clear();
  for (const BallPair& pair : broadphase_.ballPairs()) {
    const double touching = balls.radius[pair.a] + balls.radius[pair.b];
    const double squared = squaredLength(balls.position[pair.b] - balls.position[pair.a]);
    if (!world.owns(pair.a) && !world.owns(pair.b)) {
      const double leaning = touching * (1 + kLeaningGap);
      if (squared >= leaning * leaning) continue;
      isLeaning_[pair.a] = isLeaning_[pair.b] = 1;
      leaning_.push_back(pair);
      continue;
    }
    const double bound = touching + reach[pair.a] + reach[pair.b];
    if (squared > bound * bound) continue;
    sorted_.push_back(std::uint64_t{pair.a} << 32 | pair.b);
  }
  std::sort(sorted_.begin(), sorted_.end());
  for (const std::uint64_t pair : sorted_)
    contacts.push_back(
        {.a = static_cast<std::uint32_t>(pair >> 32), .b = static_cast<std::uint32_t>(pair)});
  listed_ = contacts;
}

void Candidates::findArena(const World& world, std::span<const double> reach,
                           std::vector<BallPair>& contacts) {
  contacts.clear();
  const auto collect = [&](const std::vector<std::uint32_t>& near, std::uint32_t partner) {
    for (const std::uint32_t i : near)
      if (mayTouchArena(world.arena, world.balls.position[i], world.balls.radius[i], reach[i],
                        partner))
        contacts.push_back({.a = i, .b = partner});
  };
  collect(broadphase_.nearWall(), kWall);
  collect(broadphase_.nearGround(), kGround);
  std::sort(contacts.begin(), contacts.end(), [](const BallPair& x, const BallPair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  // A ball near two pieces of the wall stands twice.
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

}  // namespace wells
