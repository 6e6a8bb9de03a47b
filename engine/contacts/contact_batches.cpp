#include "contacts/contact_batches.h"

#include <algorithm>
#include <bit>

namespace wells {
namespace {

// After the colours of contacts between balls: those for which no colour was left (a ball with so
// many neighbours), one by one; ground; wall.
constexpr std::uint8_t kColours = 64;
constexpr std::uint8_t kUncoloured = kColours;
constexpr std::uint8_t kOfGround = kColours + 1;
constexpr std::uint8_t kOfWall = kColours + 2;
constexpr std::size_t kKinds = kColours + 3;

}  // namespace

void ContactBatches::split(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                           std::span<const std::uint32_t> place) {
  const std::size_t ballCount = balls.size();
  orderPairs(pairs, balls, place);
  used_.assign(ballCount, 0);
  colour_.resize(pairs.size());
  next_.assign(kKinds + 1, 0);
  for (const std::uint32_t n : order_) {
    const auto [a, b] = pairs[n];
    std::uint8_t colour = b == kGround ? kOfGround : kOfWall;
    if (isBall(b)) {
      std::uint64_t& usedA = used_[place[a]];
      std::uint64_t& usedB = used_[place[b]];
      colour = static_cast<std::uint8_t>(std::countr_one(usedA | usedB));
      if (colour < kColours) {
        usedA |= std::uint64_t{1} << colour;
        usedB |= std::uint64_t{1} << colour;
      }
    }
    colour_[n] = colour;
    ++next_[colour + 1];
  }

  batches_.clear();
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const std::uint32_t first = next_[kind];
    const std::uint32_t last = next_[kind + 1] += first;
    const PartnerKind partner = kind == kOfGround ? PartnerKind::Ground
                                : kind == kOfWall ? PartnerKind::Wall
                                                  : PartnerKind::Ball;
    if (kind == kUncoloured)
      for (std::uint32_t n = first; n < last; ++n) batches_.push_back({partner, n, n + 1});
    else if (first < last)
      batches_.push_back({partner, first, last});
  }

  pairs_.resize(pairs.size());
  slots_.resize(pairs.size());
  for (const std::uint32_t n : order_) {
    const auto [a, b] = pairs[n];
    const std::uint32_t to = next_[colour_[n]]++;
    pairs_[to] = {place[a], isBall(b) ? place[b] : static_cast<std::uint32_t>(ballCount)};
    slots_[n] = to;
  }
}

/// Those of one ball a follow each other in both orders.
void ContactBatches::orderPairs(std::span<const BallPair> pairs,
                                std::span<const std::uint32_t> balls,
                                std::span<const std::uint32_t> place) {
  constexpr std::uint32_t kNone = 0xffffffff;
  firstOf_.assign(2 * balls.size(), kNone);  // between balls; with the arena
  const auto listOf = [&](const BallPair& pair) { return 2 * place[pair.a] + !isBall(pair.b); };
  for (std::uint32_t n = 0; n < pairs.size(); ++n) {
    std::uint32_t& first = firstOf_[listOf(pairs[n])];
    first = std::min(first, n);
  }
  order_.clear();
  order_.reserve(pairs.size());
  for (std::size_t list = 0; list < firstOf_.size(); ++list)
    for (std::uint32_t n = firstOf_[list]; n < pairs.size() && listOf(pairs[n]) == list; ++n)
      order_.push_back(n);
}

}  // namespace wells
