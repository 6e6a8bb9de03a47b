#include "contacts/contact_batches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace wells {
namespace {

constexpr std::uint32_t kColours = 64;

// After the colours within tiles and those between them: contacts for which no colour was left (of
// a ball with so many neighbours), one by one; ground; wall; what is far.
enum Last : std::uint32_t { kUncoloured = kColours, kOfGround, kOfWall, kFar, kLasts };

/// The first colour that neither has, marked as used by both; kColours: none was left.
std::uint32_t takeColour(std::uint64_t& usedA, std::uint64_t& usedB) {
  const auto free = static_cast<std::uint32_t>(std::countr_one(usedA | usedB));
  if (free >= kColours) return kColours;
  usedA |= std::uint64_t{1} << free;
  usedB |= std::uint64_t{1} << free;
  return free;
}

constexpr auto isBefore = [](const auto& x, const auto& y) {
  return x.a != y.a ? x.a < y.a : x.partner < y.partner;
};

}  // namespace

void ContactBatches::order(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                           std::span<const std::uint32_t> place) {
  balls_ = static_cast<std::uint32_t>(balls.size());
  tiles_ = (balls_ + kTileBalls - 1) / kTileBalls;
  const auto arena =
      std::ranges::partition_point(pairs, isBall, [](const BallPair& p) { return p.b; });
  const auto ballPairs = static_cast<std::uint32_t>(arena - pairs.begin());

  // Pairs of one ball a follow each other in both orders.
  runOf_.assign(balls_, {});
  for (std::uint32_t n = 0; n < ballPairs;) {
    const std::uint32_t first = n;
    while (n < ballPairs && pairs[n].a == pairs[first].a) ++n;
    runOf_[place[pairs[first].a]] = {first, n - first};
  }
  ordered_.resize(ballPairs);
  std::uint32_t to = 0;
  for (std::uint32_t k = 0; k < balls_; ++k) {
    const std::uint32_t given = std::exchange(runOf_[k].first, to);
    for (std::uint32_t n = 0; n < runOf_[k].count; ++n)
      ordered_[to++] = {k, place[pairs[given + n].b]};
  }
  ofArena_.resize(pairs.size() - ballPairs);
  std::ranges::transform(pairs.subspan(ballPairs), ofArena_.begin(), [&](const BallPair& pair) {
    return ArenaPair{place[pair.a], pair.b};
  });
  std::ranges::sort(ofArena_, isBefore);
}

void ContactBatches::split(std::span<const std::uint8_t> isNear) {
  slot_.resize(ordered_.size() + ofArena_.size());
  colour(isNear);
  listBatches();
  pairs_.resize(slot_.size());
  const auto place = [&](std::uint32_t& slot, const IndexPair& pair) {
    slot = next_[slot]++;
    pairs_[slot] = pair;
  };
  for (std::size_t n = 0; n < ordered_.size(); ++n) place(slot_[n], ordered_[n]);
  for (std::size_t n = 0; n < ofArena_.size(); ++n)
    place(slot_[ordered_.size() + n], {ofArena_[n].a, balls_});
}

std::uint32_t ContactBatches::find(std::uint32_t a, std::uint32_t partner) const {
  if (isBall(partner)) {
    const auto [first, count] = runOf_[a];
    for (std::uint32_t n = first; n < first + count; ++n)
      if (ordered_[n].b == partner) return slot_[n];
    return kNoPair;
  }
  const ArenaPair pair{a, partner};
  const auto found = std::ranges::lower_bound(ofArena_, pair, isBefore);
  if (found == ofArena_.end() || isBefore(pair, *found)) return kNoPair;
  return slot_[ordered_.size() + static_cast<std::size_t>(found - ofArena_.begin())];
}

void ContactBatches::colour(std::span<const std::uint8_t> isNear) {
  const std::uint32_t between = tiles_ * kColours;
  used_.assign(balls_, {});
  next_.assign(between + kLasts + 1, 0);
  for (std::size_t n = 0; n < ordered_.size(); ++n) {
    std::uint32_t& list = slot_[n];
    list = between + kFar;
    if (isNear[n]) {
      const auto [a, b] = ordered_[n];
      const std::uint32_t tile = a / kTileBalls;
      const bool isWithin = tile == b / kTileBalls;
      std::uint64_t Used::*const kind = isWithin ? &Used::within : &Used::between;
      const std::uint32_t colour = takeColour(used_[a].*kind, used_[b].*kind);
      list = isWithin && colour < kColours ? tile * kColours + colour : between + colour;
    }
    ++next_[list + 1];
  }
  for (std::size_t n = 0; n < ofArena_.size(); ++n) {
    std::uint32_t& list = slot_[ordered_.size() + n];
    list = between + (ofArena_[n].partner == kGround ? kOfGround : kOfWall);
    ++next_[list + 1];
  }
  for (std::size_t list = 1; list < next_.size(); ++list) next_[list] += next_[list - 1];
}

void ContactBatches::listBatches() {
  batches_.clear();
  arenaBatches_.clear();
  const std::uint32_t between = tiles_ * kColours;
  for (std::uint32_t list = 0; list < between + kFar; ++list) {
    const std::uint32_t first = next_[list];
    const std::uint32_t last = next_[list + 1];
    if (first == last) continue;
    const std::uint32_t tile = list < between ? list / kColours : kNoTile;
    constexpr auto kOf = ContactBatch::Of::Pairs;
    if (list == between + kOfGround)
      arenaBatches_.push_back({PartnerKind::Ground, kOf, tile, first, last});
    else if (list == between + kOfWall)
      arenaBatches_.push_back({PartnerKind::Wall, kOf, tile, first, last});
    else if (list == between + kUncoloured)
      for (std::uint32_t n = first; n < last; ++n)
        batches_.push_back({PartnerKind::Ball, kOf, tile, n, n + 1});
    else
      batches_.push_back({PartnerKind::Ball, kOf, tile, first, last});
  }
  firstFar_ = next_[between + kFar];
  ballBatches_ = batches_.size();
  setLate({});
}

void ContactBatches::setLate(std::span<const std::uint32_t> touching) {
  std::array<std::uint32_t, kColours + 2> next = {};
  lateColour_.resize(touching.size());
  for (const std::uint32_t slot : touching) used_[pairs_[slot].a] = used_[pairs_[slot].b] = {};
  for (std::size_t n = 0; n < touching.size(); ++n) {
    const auto [a, b] = pairs_[touching[n]];
    lateColour_[n] = takeColour(used_[a].between, used_[b].between);
    ++next[lateColour_[n] + 1];
  }
  for (std::size_t list = 1; list < next.size(); ++list) next[list] += next[list - 1];
  batches_.resize(ballBatches_);
  for (std::uint32_t list = 0; list <= kColours; ++list) {
    const std::uint32_t size = list < kColours ? next[list + 1] - next[list] : 1;
    for (std::uint32_t n = next[list]; n < next[list + 1]; n += size)
      batches_.push_back({PartnerKind::Ball, ContactBatch::Of::Late, kNoTile, n, n + size});
  }
  batches_.insert(batches_.end(), arenaBatches_.begin(), arenaBatches_.end());
  late_.resize(touching.size());
  for (std::size_t n = 0; n < touching.size(); ++n) late_[next[lateColour_[n]]++] = touching[n];
}

}  // namespace wells
