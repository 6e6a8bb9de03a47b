#include "contacts/contact_batches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace wells {
namespace {

constexpr std::uint32_t kColours = 64;
constexpr std::size_t kLeastPairs = 4096;  // that a thread orders
constexpr std::size_t kLeastTiles = 4;     // that a thread colours

// Behind the colours within tiles and those between them: contacts for which no colour was left (of
// a ball with so many neighbours), one by one; ground; wall; what is far, tile by tile.
enum Last : std::uint32_t { kUncoloured = kColours, kOfGround, kOfWall, kFar };

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
    const auto first = between_.begin() + static_cast<std::ptrdiff_t>(ordersOf(tile).begin);
    std::for_each(first, first + betweenOf_[tile], action);
  }
}

void ContactBatches::order(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                           std::span<const std::uint32_t> place, ThreadPool& pool) {
  balls_ = static_cast<std::uint32_t>(balls.size());
  tiles_ = (balls_ + kTileBalls - 1) / kTileBalls;
  const auto arena =
      std::ranges::partition_point(pairs, isBall, [](const BallPair& p) { return p.b; });
  const auto ballPairs = static_cast<std::size_t>(arena - pairs.begin());

  // Pairs of one ball a follow each other in both orders.
  runOf_.assign(balls_, {});
  pool.forRanges(ballPairs, kLeastPairs, [&](std::size_t begin, std::size_t end, std::size_t) {
    while (begin > 0 && begin < end && pairs[begin].a == pairs[begin - 1].a) ++begin;
    for (std::size_t n = begin; n < end;) {
      const std::size_t first = n;
      while (n < ballPairs && pairs[n].a == pairs[first].a) ++n;
      Run& run = runOf_[place[pairs[first].a]];
      run.given = static_cast<std::uint32_t>(first);
      run.count = static_cast<std::uint32_t>(n - first);
    }
  });
  std::uint32_t first = 0;
  for (Run& run : runOf_) run.first = std::exchange(first, first + run.count);
  ordered_.resize(ballPairs);
  pool.forRanges(balls_, kTileBalls, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const Run& run = runOf_[k];
      for (std::uint32_t n = 0; n < run.count; ++n)
        ordered_[run.first + n] = {static_cast<std::uint32_t>(k), place[pairs[run.given + n].b]};
    }
  });
  ofArena_.resize(pairs.size() - ballPairs);
  std::ranges::transform(pairs.subspan(ballPairs), ofArena_.begin(), [&](const BallPair& pair) {
    return ArenaPair{place[pair.a], pair.b};
  });
  std::ranges::sort(ofArena_, isBefore);
}

void ContactBatches::split(std::span<const std::uint8_t> isNear, ThreadPool& pool) {
  const auto forTiles = [&](auto action) {
    pool.forRanges(tiles_, kLeastTiles, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t tile = begin; tile < end; ++tile) action(static_cast<std::uint32_t>(tile));
    });
  };
  slot_.resize(ordered_.size() + ofArena_.size());
  pairs_.resize(slot_.size());
  between_.resize(ordered_.size());
  betweenOf_.resize(tiles_);
  used_.resize(balls_);
  next_.assign((tiles_ + 1) * kColours + kFar - kColours + tiles_ + 1, 0);
  forTiles([&](std::uint32_t tile) { colourTile(tile, isNear); });
  colourBetween();
  for (std::size_t list = 1; list < next_.size(); ++list) next_[list] += next_[list - 1];
  listBatches();
  forTiles([&](std::uint32_t tile) { placeTile(tile); });
  placeOthers();
}

IndexRange ContactBatches::ordersOf(std::uint32_t tile) const {
  const auto firstOf = [&](std::uint32_t k) {
    return k < balls_ ? runOf_[k].first : ordered_.size();
  };
  return {firstOf(tile * kTileBalls), firstOf((tile + 1) * kTileBalls)};
}

// All that the balls of a tile have as the first of two.
void ContactBatches::colourTile(std::uint32_t tile, std::span<const std::uint8_t> isNear) {
  const std::uint32_t firstBall = tile * kTileBalls;
  const std::uint32_t lastBall = std::min(balls_, firstBall + kTileBalls);
  std::fill(used_.begin() + firstBall, used_.begin() + lastBall, Used{});
  const std::uint32_t far = tiles_ * kColours + kFar + tile;
  const auto [begin, end] = ordersOf(tile);
  std::uint32_t* between = between_.data() + begin;
  for (std::size_t n = begin; n < end; ++n) {
    const auto [a, b] = ordered_[n];
    slot_[n] = far;
    if (isNear[n]) {
      const bool isWithin = firstBall <= b && b < lastBall;
      const std::uint32_t colour =
          isWithin ? takeColour(used_[a].within, used_[b].within) : kColours;
      slot_[n] = tile * kColours + colour;
      if (colour == kColours) {
        *between++ = static_cast<std::uint32_t>(n);
        continue;
      }
    }
    ++next_[slot_[n] + 1];
  }
  betweenOf_[tile] = static_cast<std::uint32_t>(between - between_.data() - begin);
}

void ContactBatches::colourBetween() {
  const std::uint32_t between = tiles_ * kColours;
  forEachBetween([&](std::uint32_t n) {
    const auto [a, b] = ordered_[n];
    slot_[n] = between + takeColour(used_[a].between, used_[b].between);
    ++next_[slot_[n] + 1];
  });
  for (std::size_t n = 0; n < ofArena_.size(); ++n) {
    std::uint32_t& list = slot_[ordered_.size() + n];
    list = between + (ofArena_[n].partner == kGround ? kOfGround : kOfWall);
    ++next_[list + 1];
  }
}

// Those within it, and those that are far.
void ContactBatches::placeTile(std::uint32_t tile) {
  const std::uint32_t between = tiles_ * kColours;
  const auto [begin, end] = ordersOf(tile);
  for (std::size_t n = begin; n < end; ++n)
    if (slot_[n] < between || slot_[n] >= between + kFar) place(slot_[n], ordered_[n]);
}

void ContactBatches::placeOthers() {
  forEachBetween([&](std::uint32_t n) { place(slot_[n], ordered_[n]); });
  for (std::size_t n = 0; n < ofArena_.size(); ++n)
    place(slot_[ordered_.size() + n], {ofArena_[n].a, balls_});
}

/// Makes of the list that a pair is in its number in pairs().
void ContactBatches::place(std::uint32_t& slot, const IndexPair& pair) {
  slot = next_[slot]++;
  pairs_[slot] = pair;
}

std::uint32_t ContactBatches::find(std::uint32_t a, std::uint32_t partner) const {
  if (isBall(partner)) {
    const Run& run = runOf_[a];
    for (std::uint32_t n = run.first; n < run.first + run.count; ++n)
      if (ordered_[n].b == partner) return slot_[n];
    return kNoPair;
  }
  const ArenaPair pair{a, partner};
  const auto found = std::ranges::lower_bound(ofArena_, pair, isBefore);
  if (found == ofArena_.end() || isBefore(pair, *found)) return kNoPair;
  return slot_[ordered_.size() + static_cast<std::size_t>(found - ofArena_.begin())];
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
