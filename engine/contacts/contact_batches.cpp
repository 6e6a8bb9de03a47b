#include "contacts/contact_batches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace wells {
namespace {

constexpr std::uint32_t kColours = 64;
constexpr std::uint32_t kSome = 8;      // pairs of a ball; most have no more
constexpr std::size_t kLeastTiles = 4;  // that a thread colours

// Behind the colours within tiles and those between them: contacts for which no colour was left (of
// a ball with so many neighbours), one by one; ground; wall.
enum Last : std::uint32_t { kUncoloured = kColours, kOfGround, kOfWall, kLasts };

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

template <class Action>
void ContactBatches::forEachBetween(Action action) const {
  for (std::uint32_t tile = 0; tile < tiles_; ++tile) {
    const auto first = between_.begin() + static_cast<std::ptrdiff_t>(pairsOf(tile).begin);
    std::for_each(first, first + betweenOf_[tile], action);
  }
}

void ContactBatches::split(const PairsByBall& near, std::span<const BallPair> arena,
                           std::span<const std::uint32_t> place, std::size_t idle,
                           ThreadPool& pool) {
  const auto forTiles = [&](auto action) {
    pool.forRanges(tiles_, kLeastTiles, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t tile = begin; tile < end; ++tile) action(static_cast<std::uint32_t>(tile));
    });
  };
  near_ = near;
  balls_ = static_cast<std::uint32_t>(near_.firstOf.size() - 1);
  tiles_ = (balls_ + kTileBalls - 1) / kTileBalls;
  listArena(arena, place);

  slot_.resize(near_.pairs.size() + ofArena_.size());
  between_.resize(near_.pairs.size());
  betweenOf_.resize(tiles_);
  used_.resize(balls_);
  next_.assign(tiles_ * kColours + kLasts + 1, 0);
  forTiles([&](std::uint32_t tile) { colourTile(tile); });
  colourBetween();
  for (std::size_t list = 1; list < next_.size(); ++list) next_[list] += next_[list - 1];
  listBatches();
  firstIdle_ = static_cast<std::uint32_t>(slot_.size());
  firstLate_ = static_cast<std::uint32_t>(slot_.size() + idle);
  pairs_.resize(firstLate_);
  forTiles([&](std::uint32_t tile) { placeTile(tile); });
  placeOthers();
  setLate({});
}

// In order of the balls, which are more than the pairs.
void ContactBatches::listArena(std::span<const BallPair> arena,
                               std::span<const std::uint32_t> place) {
  constexpr std::uint8_t kWithWall = 1;
  constexpr std::uint8_t kWithGround = 2;
  withArena_.assign(balls_, 0);
  for (const auto& [a, partner] : arena)
    withArena_[place[a]] |= partner == kWall ? kWithWall : kWithGround;
  ofArena_.clear();
  for (std::uint32_t k = 0; k < balls_; ++k) {
    if (withArena_[k] & kWithWall) ofArena_.push_back({k, kWall});
    if (withArena_[k] & kWithGround) ofArena_.push_back({k, kGround});
  }
}

IndexRange ContactBatches::pairsOf(std::uint32_t tile) const {
  return {near_.firstOf[tile * kTileBalls],
          near_.firstOf[std::min(balls_, (tile + 1) * kTileBalls)]};
}

// All that the balls of a tile have as the first of two.
void ContactBatches::colourTile(std::uint32_t tile) {
  const std::uint32_t firstBall = tile * kTileBalls;
  const std::uint32_t lastBall = std::min(balls_, firstBall + kTileBalls);
  std::fill(used_.begin() + firstBall, used_.begin() + lastBall, Used{});
  const auto [begin, end] = pairsOf(tile);
  std::uint32_t* between = between_.data() + begin;
  for (std::size_t n = begin; n < end; ++n) {
    const auto [a, b] = near_.pairs[n];
    const bool isWithin = firstBall <= b && b < lastBall;
    const std::uint32_t colour = isWithin ? takeColour(used_[a].within, used_[b].within) : kColours;
    if (colour < kColours) {
      slot_[n] = tile * kColours + colour;
      ++next_[slot_[n] + 1];
    } else {
      slot_[n] = tiles_ * kColours;
      *between++ = static_cast<std::uint32_t>(n);
    }
  }
  betweenOf_[tile] = static_cast<std::uint32_t>(between - between_.data() - begin);
}

void ContactBatches::colourBetween() {
  const std::uint32_t between = tiles_ * kColours;
  forEachBetween([&](std::uint32_t n) {
    const auto [a, b] = near_.pairs[n];
    slot_[n] = between + takeColour(used_[a].between, used_[b].between);
    ++next_[slot_[n] + 1];
  });
  for (std::size_t n = 0; n < ofArena_.size(); ++n) {
    std::uint32_t& list = slot_[near_.pairs.size() + n];
    list = between + (ofArena_[n].partner == kGround ? kOfGround : kOfWall);
    ++next_[list + 1];
  }
}

void ContactBatches::placeTile(std::uint32_t tile) {
  const auto [begin, end] = pairsOf(tile);
  for (std::size_t n = begin; n < end; ++n)
    if (slot_[n] < tiles_ * kColours) place(slot_[n], near_.pairs[n]);
}

void ContactBatches::placeOthers() {
  forEachBetween([&](std::uint32_t n) { place(slot_[n], near_.pairs[n]); });
  for (std::size_t n = 0; n < ofArena_.size(); ++n)
    place(slot_[near_.pairs.size() + n], {ofArena_[n].a, balls_});
}

/// Makes of the list that a pair is in its number in pairs().
void ContactBatches::place(std::uint32_t& slot, const IndexPair& pair) {
  slot = next_[slot]++;
  pairs_[slot] = pair;
}

std::uint32_t ContactBatches::find(std::uint32_t a, std::uint32_t partner) const {
  if (isBall(partner)) {
    // Without a branch for each: which one it is cannot be foretold.
    const std::uint32_t end = near_.firstOf[a + 1];
    for (std::uint32_t first = near_.firstOf[a]; first < end; first += kSome) {
      std::uint32_t found = end;
      for (std::uint32_t k = 0; k < kSome; ++k) {
        const std::uint32_t n = std::min(first + k, end - 1);
        found = near_.pairs[n].b == partner ? n : found;
      }
      if (found != end) return slot_[found];
    }
    return kNoPair;
  }
  const ArenaPair pair{a, partner};
  const auto found = std::ranges::lower_bound(ofArena_, pair, isBefore);
  if (found == ofArena_.end() || isBefore(pair, *found)) return kNoPair;
  return slot_[near_.pairs.size() + static_cast<std::size_t>(found - ofArena_.begin())];
}

void ContactBatches::listBatches() {
  batches_.clear();
  arenaBatches_.clear();
  const std::uint32_t between = tiles_ * kColours;
  for (std::uint32_t list = 0; list < between + kLasts; ++list) {
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
  ballBatches_ = batches_.size();
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
