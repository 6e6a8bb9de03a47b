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

void ContactBatches::split(std::span<const BallPair> pairs, std::span<const std::uint32_t> place,
                           std::size_t ballCount) {
  used_.assign(ballCount, 0);
  colour_.resize(pairs.size());
  next_.assign(kKinds + 1, 0);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
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
  source_.resize(pairs.size());
  for (std::uint32_t n = 0; n < pairs.size(); ++n) {
    const auto [a, b] = pairs[n];
    const std::uint32_t to = next_[colour_[n]]++;
    pairs_[to] = {place[a], isBall(b) ? place[b] : static_cast<std::uint32_t>(ballCount)};
    source_[to] = n;
  }
}

}  // namespace wells
