#include "world/islands.h"

#include <algorithm>
#include <numeric>

#include "math/room.h"
#include "math/union_find.h"

namespace wells {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

void Islands::find(std::span<const BallPair> ballPairs, std::span<const BallPair> arenaPairs,
                   std::span<const std::uint32_t> among) {
  const std::size_t size = among.empty() ? 0 : among.back() + 1;
  if (parent_.size() < size) {
    parent_.resize(size);
    islandOf_.resize(size);
    isPaired_.resize(size);
  }
  for (const std::uint32_t i : among) {
    parent_[i] = i;
    islandOf_[i] = kNone;
    isPaired_[i] = 0;
  }
  for (const BallPair& c : arenaPairs) isPaired_[c.a] = 1;
  std::uint32_t ball = kNone;
  std::uint32_t root = kNone;  // of that ball, who has several pairs in a row
  for (const auto& [a, b] : ballPairs) {
    if (a != ball) {
      ball = a;
      root = rootOf(parent_, a);
    }
    if (parent_[b] == root) continue;
    const std::uint32_t other = rootOf(parent_, b);
    if (other == root) continue;
    // The lower id is the root, so that islands come in order of their lowest ball.
    const std::uint32_t lower = std::min(root, other);
    parent_[std::max(root, other)] = lower;
    root = lower;
    isPaired_[lower] = 1;
  }

  // Number the islands and count, then fill: two passes over balls and pairs.
  ballStart_.assign(1, 0);
  for (const std::uint32_t i : among) {
    if (parent_[i] == i && !isPaired_[i]) continue;
    const std::uint32_t r = rootOf(parent_, i);
    if (r == i) {
      islandOf_[i] = static_cast<std::uint32_t>(ballStart_.size() - 1);
      ballStart_.push_back(0);
    } else {
      islandOf_[i] = islandOf_[r];
    }
    ++ballStart_[islandOf_[i] + 1];
  }
  pairStart_.assign(ballStart_.size(), 0);
  for (const auto& list : {ballPairs, arenaPairs})
    for (const BallPair& c : list) ++pairStart_[islandOf_[c.a] + 1];
  std::partial_sum(ballStart_.begin(), ballStart_.end(), ballStart_.begin());
  std::partial_sum(pairStart_.begin(), pairStart_.end(), pairStart_.begin());

  resizeAfresh(balls_, ballStart_.back());
  resizeAfresh(pairs_, pairStart_.back());
  next_.assign(ballStart_.begin(), ballStart_.end() - 1);
  for (const std::uint32_t i : among)
    if (islandOf_[i] != kNone) balls_[next_[islandOf_[i]]++] = i;
  next_.assign(pairStart_.begin(), pairStart_.end() - 1);
  for (const auto& list : {ballPairs, arenaPairs})
    for (const BallPair& c : list) pairs_[next_[islandOf_[c.a]]++] = c;
}

}  // namespace wells
