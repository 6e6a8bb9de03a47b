#include "contacts/contact_batches.h"

#include <algorithm>
#include <bit>

namespace wells {
namespace {

constexpr std::uint32_t kColours = 64;

// After the colours within tiles and those between them: contacts for which no colour was left (of
// a ball with so many neighbours), one by one; ground; wall.
enum Last : std::uint32_t { kUncoloured = kColours, kOfGround, kOfWall, kLasts };

std::uint32_t lastOf(std::uint32_t partner) {
  return partner == kGround ? kOfGround : kOfWall;
}

}  // namespace

void ContactBatches::split(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                           std::span<const std::uint32_t> place) {
  tiles_ = (static_cast<std::uint32_t>(balls.size()) + kTileBalls - 1) / kTileBalls;
  orderPairs(pairs, balls, place);
  colour();
  listBatches();
  pairs_.resize(pairs.size());
  slots_.resize(pairs.size());
  for (const Ordered& pair : ordered_) {
    const std::uint32_t to = next_[pair.list]++;
    pairs_[to] = pair.balls;
    slots_[pair.given] = to;
  }
}

/// Those of one ball a follow each other in both orders.
void ContactBatches::orderPairs(std::span<const BallPair> pairs,
                                std::span<const std::uint32_t> balls,
                                std::span<const std::uint32_t> place) {
  const auto ballCount = static_cast<std::uint32_t>(balls.size());
  const auto count = static_cast<std::uint32_t>(pairs.size());
  const std::uint32_t between = tiles_ * kColours;
  firstOf_.assign(ballCount, {count, count});
  for (std::uint32_t n = 0; n < count; ++n) {
    const auto [a, b] = pairs[n];
    if (n > 0 && pairs[n - 1].a == a && isBall(pairs[n - 1].b) == isBall(b)) continue;
    (isBall(b) ? firstOf_[place[a]].ball : firstOf_[place[a]].arena) = n;
  }
  ordered_.clear();
  for (std::uint32_t k = 0; k < ballCount; ++k) {
    const auto isMine = [&](std::uint32_t n) { return n < count && pairs[n].a == balls[k]; };
    for (std::uint32_t n = firstOf_[k].ball; isMine(n) && isBall(pairs[n].b); ++n)
      ordered_.push_back({{k, place[pairs[n].b]}, n, 0});
    for (std::uint32_t n = firstOf_[k].arena; isMine(n); ++n)
      ordered_.push_back({{k, ballCount}, n, between + lastOf(pairs[n].b)});
  }
}

void ContactBatches::colour() {
  const std::uint32_t between = tiles_ * kColours;
  used_.assign(firstOf_.size(), {});
  next_.assign(between + kLasts + 1, 0);
  for (Ordered& pair : ordered_) {
    if (pair.balls.b < used_.size()) {
      const std::uint32_t tile = pair.balls.a / kTileBalls;
      const bool isWithin = tile == pair.balls.b / kTileBalls;
      std::uint64_t Used::*const kind = isWithin ? &Used::within : &Used::between;
      std::uint64_t& usedA = used_[pair.balls.a].*kind;
      std::uint64_t& usedB = used_[pair.balls.b].*kind;
      const auto free = static_cast<std::uint32_t>(std::countr_one(usedA | usedB));
      pair.list = between + kUncoloured;
      if (free < kColours) {
        usedA |= std::uint64_t{1} << free;
        usedB |= std::uint64_t{1} << free;
        pair.list = (isWithin ? tile * kColours : between) + free;
      }
    }
    ++next_[pair.list + 1];
  }
  for (std::size_t list = 1; list < next_.size(); ++list) next_[list] += next_[list - 1];
}

void ContactBatches::listBatches() {
  batches_.clear();
  const std::uint32_t between = tiles_ * kColours;
  for (std::uint32_t list = 0; list < between + kLasts; ++list) {
    const std::uint32_t first = next_[list];
    const std::uint32_t last = next_[list + 1];
    if (list == between + kUncoloured) {
      for (std::uint32_t n = first; n < last; ++n)
        batches_.push_back({PartnerKind::Ball, kNoTile, n, n + 1});
      continue;
    }
    if (first == last) continue;
    const PartnerKind partner = list == between + kOfGround ? PartnerKind::Ground
                                : list == between + kOfWall ? PartnerKind::Wall
                                                            : PartnerKind::Ball;
    batches_.push_back({partner, list < between ? list / kColours : kNoTile, first, last});
  }
}

}  // namespace wells
