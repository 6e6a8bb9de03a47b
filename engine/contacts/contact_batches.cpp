#include "contacts/contact_batches.h"

#include <algorithm>
#include <array>
#include <bit>

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

}  // namespace

void ContactBatches::order(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                           std::span<const std::uint32_t> place) {
  balls_ = static_cast<std::uint32_t>(balls.size());
  tiles_ = (balls_ + kTileBalls - 1) / kTileBalls;
  const auto arena =
      std::ranges::partition_point(pairs, isBall, [](const BallPair& p) { return p.b; });
  const auto ballPairs = static_cast<std::uint32_t>(arena - pairs.begin());
  const auto all = static_cast<std::uint32_t>(pairs.size());

  // Pairs of one ball a follow each other in both orders.
  runOf_.assign(balls_, {});
  for (std::uint32_t n = 0; n < ballPairs;) {
    const std::uint32_t first = n;
    while (n < ballPairs && pairs[n].a == pairs[first].a) ++n;
    runOf_[place[pairs[first].a]] = {first, n - first};
  }
  ordered_.resize(ballPairs);
  given_.resize(ballPairs);
  std::uint32_t to = 0;
  for (std::uint32_t k = 0; k < balls_; ++k) {
    const auto [first, count] = runOf_[k];
    for (std::uint32_t n = first; n < first + count; ++n, ++to) {
      ordered_[to] = {k, place[pairs[n].b]};
      given_[to] = n;
    }
  }
  ofArena_.resize(all - ballPairs);
  for (std::uint32_t n = ballPairs; n < all; ++n) ofArena_[n - ballPairs] = {place[pairs[n].a], n};
  std::ranges::sort(ofArena_, [](const IndexPair& x, const IndexPair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  listOfArena_.resize(ofArena_.size());
  const std::uint32_t between = tiles_ * kColours;
  std::ranges::transform(ofArena_, listOfArena_.begin(), [&](const IndexPair& pair) {
    return between + (pairs[pair.b].b == kGround ? kOfGround : kOfWall);
  });
}

void ContactBatches::split(std::span<const std::uint8_t> isNear) {
  colour(isNear);
  listBatches();
  pairs_.resize(ordered_.size() + ofArena_.size());
  slots_.resize(pairs_.size());
  for (std::size_t n = 0; n < ordered_.size(); ++n) {
    const std::uint32_t to = next_[list_[n]]++;
    pairs_[to] = ordered_[n];
    slots_[given_[n]] = to;
  }
  for (std::size_t n = 0; n < ofArena_.size(); ++n) {
    const std::uint32_t to = next_[listOfArena_[n]]++;
    pairs_[to] = {ofArena_[n].a, balls_};
    slots_[ofArena_[n].b] = to;
  }
}

void ContactBatches::colour(std::span<const std::uint8_t> isNear) {
  const std::uint32_t between = tiles_ * kColours;
  used_.assign(balls_, {});
  next_.assign(between + kLasts + 1, 0);
  list_.resize(ordered_.size());
  for (std::size_t n = 0; n < ordered_.size(); ++n) {
    list_[n] = between + kFar;
    if (isNear[n]) {
      const auto [a, b] = ordered_[n];
      const std::uint32_t tile = a / kTileBalls;
      const bool isWithin = tile == b / kTileBalls;
      std::uint64_t Used::*const kind = isWithin ? &Used::within : &Used::between;
      const std::uint32_t colour = takeColour(used_[a].*kind, used_[b].*kind);
      list_[n] = isWithin && colour < kColours ? tile * kColours + colour : between + colour;
    }
    ++next_[list_[n] + 1];
  }
  for (const std::uint32_t list : listOfArena_) ++next_[list + 1];
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
