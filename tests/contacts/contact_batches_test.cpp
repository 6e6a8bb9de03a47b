#include "contacts/contact_batches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

using Ids = std::vector<std::uint32_t>;

/// A crowd whose balls are the ids `order`, in that order.
struct Split {
  Split(Ids order, std::vector<BallPair> given) : balls(std::move(order)), pairs(std::move(given)) {
    const auto byBoth = [](const BallPair& x, const BallPair& y) {
      return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    };
    const auto arena =
        std::ranges::stable_partition(pairs, isBall, [](const BallPair& p) { return p.b; });
    std::sort(pairs.begin(), arena.begin(), byBoth);
    std::sort(arena.begin(), arena.end(), byBoth);
    place.resize(balls.empty() ? 0 : *std::ranges::max_element(balls) + 1);
    for (std::uint32_t k = 0; k < balls.size(); ++k) place[balls[k]] = k;
    batches.split(pairs, balls, place);
  }

  std::uint32_t arena() const { return static_cast<std::uint32_t>(balls.size()); }
  std::span<const IndexPair> pairsOf(const ContactBatch& batch) const {
    return batches.pairs().subspan(batch.first, batch.last - batch.first);
  }

  Ids balls;
  std::vector<BallPair> pairs;
  Ids place;
  ContactBatches batches;
};

Ids shuffled(Random& random, std::uint32_t count, std::uint32_t idStride) {
  Ids ids(count);
  for (std::uint32_t k = 0; k < count; ++k) ids[k] = idStride * k + 1;
  for (std::uint32_t k = count; k > 1; --k)
    std::swap(ids[k - 1], ids[static_cast<std::uint32_t>(random.below(k))]);
  return ids;
}

/// Most pairs are of balls near each other in the order, as in space; some balls touch the arena,
/// some both pieces of it.
Split randomCrowd(std::uint64_t seed, std::uint32_t count) {
  Random random(seed);
  Ids balls = shuffled(random, count, 3);
  std::set<std::pair<std::uint32_t, std::uint32_t>> unique;
  for (std::uint32_t n = 0; n < 6 * count; ++n) {
    const auto k = static_cast<std::uint32_t>(random.below(count));
    const std::uint32_t range = random.uniform() < 0.9 ? 20 : count;
    const auto other = (k + 1 + static_cast<std::uint32_t>(random.below(range))) % count;
    if (other != k) unique.insert(std::minmax(balls[k], balls[other]));
  }
  std::vector<BallPair> pairs;
  for (const auto& [a, b] : unique) pairs.push_back({a, b});
  for (const std::uint32_t id : balls) {
    if (random.uniform() < 0.3) pairs.push_back({id, kGround});
    if (random.uniform() < 0.2) pairs.push_back({id, kWall});
  }
  return {std::move(balls), std::move(pairs)};
}

void expectEachPairOnce(const Split& crowd) {
  const auto slots = crowd.batches.slots();
  const auto placed = crowd.batches.pairs();
  ASSERT_EQ(slots.size(), crowd.pairs.size());
  ASSERT_EQ(placed.size(), crowd.pairs.size());
  Ids sorted(slots.begin(), slots.end());
  std::ranges::sort(sorted);
  for (std::uint32_t n = 0; n < sorted.size(); ++n) ASSERT_EQ(sorted[n], n);
  for (std::size_t n = 0; n < slots.size(); ++n) {
    const auto [a, b] = crowd.pairs[n];
    EXPECT_EQ(placed[slots[n]].a, crowd.place[a]);
    EXPECT_EQ(placed[slots[n]].b, isBall(b) ? crowd.place[b] : crowd.arena());
  }
  std::uint32_t end = 0;
  for (const ContactBatch& batch : crowd.batches.batches()) {
    EXPECT_EQ(batch.first, end);
    EXPECT_LT(batch.first, batch.last);
    end = batch.last;
  }
  EXPECT_EQ(end, placed.size());
}

void expectNoBallTwiceInABatch(const Split& crowd) {
  for (const ContactBatch& batch : crowd.batches.batches()) {
    std::set<std::uint32_t> seen;
    for (const auto& [a, b] : crowd.pairsOf(batch)) {
      EXPECT_TRUE(seen.insert(a).second) << a;
      EXPECT_TRUE(b == crowd.arena() || seen.insert(b).second) << b;
    }
  }
}

void expectTilesHoldBothBalls(const Split& crowd) {
  for (const ContactBatch& batch : crowd.batches.batches())
    for (const auto& [a, b] : crowd.pairsOf(batch)) {
      if (batch.tile == kNoTile) {
        EXPECT_TRUE(b == crowd.arena() || a / kTileBalls != b / kTileBalls);
        continue;
      }
      EXPECT_EQ(a / kTileBalls, batch.tile);
      EXPECT_EQ(b / kTileBalls, batch.tile);
      EXPECT_LT(b, crowd.arena());
    }
}

/// Tiles in their order, then what is between them, then ground, then wall.
void expectOrder(const Split& crowd) {
  std::uint64_t before = 0;
  for (const ContactBatch& batch : crowd.batches.batches()) {
    const std::uint64_t rank =
        std::uint64_t{batch.tile} + static_cast<std::uint64_t>(batch.partner);
    EXPECT_GE(rank, before);
    before = rank;
  }
}

/// That a batch with the ground has no pair with the wall or a ball, and so on.
void expectPartners(const Split& crowd) {
  const auto slots = crowd.batches.slots();
  std::map<std::uint32_t, std::uint32_t> partnerAt;
  for (std::size_t n = 0; n < slots.size(); ++n) partnerAt[slots[n]] = crowd.pairs[n].b;
  for (const ContactBatch& batch : crowd.batches.batches())
    for (std::uint32_t n = batch.first; n < batch.last; ++n) {
      const std::uint32_t b = partnerAt[n];
      const PartnerKind kind = isBall(b)      ? PartnerKind::Ball
                               : b == kGround ? PartnerKind::Ground
                                              : PartnerKind::Wall;
      EXPECT_EQ(batch.partner, kind);
    }
}

void expectWellSplit(const Split& crowd) {
  expectEachPairOnce(crowd);
  expectNoBallTwiceInABatch(crowd);
  expectTilesHoldBothBalls(crowd);
  expectOrder(crowd);
  expectPartners(crowd);
}

TEST(ContactBatches, SplitCrowdsOfAllSizes) {
  for (const std::uint32_t count : {2, 3, 65, 511, 512, 513, 1024, 3000}) {
    const Split crowd = randomCrowd(count, count);
    EXPECT_EQ(crowd.batches.tiles(), (count + 511) / 512);
    expectWellSplit(crowd);
    if (testing::Test::HasFailure()) FAIL() << count << " balls";
  }
}

TEST(ContactBatches, OfNothingAreNone) {
  const Split nobody({}, {});
  EXPECT_TRUE(nobody.batches.batches().empty());
  EXPECT_TRUE(nobody.batches.pairs().empty());
  const Split strangers({4, 2, 9}, {});
  EXPECT_TRUE(strangers.batches.batches().empty());
  EXPECT_EQ(strangers.batches.tiles(), 1u);
}

TEST(ContactBatches, OfTheArenaAlone) {
  const Split crowd({5, 1, 3}, {{1, kGround}, {3, kWall}, {3, kGround}, {5, kWall}});
  expectWellSplit(crowd);
  ASSERT_EQ(crowd.batches.batches().size(), 2u);
  EXPECT_EQ(crowd.batches.batches()[0].partner, PartnerKind::Ground);
  EXPECT_EQ(crowd.batches.batches()[1].partner, PartnerKind::Wall);
}

// A ball has 64 colours within its tile and 64 outside; what is left over goes one by one.
TEST(ContactBatches, HoldABallOfTwoHundredNeighbours) {
  for (const std::uint32_t center : {0u, 100u, 600u}) {
    Ids balls(1000);
    std::iota(balls.begin(), balls.end(), 0u);
    std::vector<BallPair> pairs = {{center, kGround}};
    for (std::uint32_t n = 0; n < 200; ++n) {
      const std::uint32_t other = 450 + n;
      if (other != center) pairs.push_back({std::min(center, other), std::max(center, other)});
    }
    const Split crowd(balls, pairs);
    expectEachPairOnce(crowd);
    expectNoBallTwiceInABatch(crowd);
    expectOrder(crowd);
    expectPartners(crowd);
    EXPECT_EQ(crowd.batches.batches().size(), crowd.pairs.size());  // all share a ball
  }
}

// A heap has up to a dozen neighbours a ball; the fewer batches, the fuller the lanes. Greedy
// colouring needs fewer than two colours for each contact of the two balls.
TEST(ContactBatches, AreFewerThanTwiceTheContactsOfABall) {
  const Split crowd = randomCrowd(7, 512);
  std::vector<std::size_t> contacts(crowd.balls.size());
  std::size_t most = 0;
  for (const auto& [a, b] : crowd.batches.pairs()) {
    if (b == crowd.arena()) continue;
    most = std::max({most, ++contacts[a], ++contacts[b]});
  }
  ASSERT_LT(2 * most, 64u);
  EXPECT_LE(crowd.batches.batches().size(), 2 * most - 1 + 2);
}

TEST(ContactBatches, ForgetTheCrowdBefore) {
  Split used = randomCrowd(3, 3000);
  const Split fresh = randomCrowd(4, 700);
  used.batches.split(fresh.pairs, fresh.balls, fresh.place);
  const auto listed = [](std::span<const std::uint32_t> slots) {
    return Ids(slots.begin(), slots.end());
  };
  EXPECT_EQ(listed(used.batches.slots()), listed(fresh.batches.slots()));
  EXPECT_EQ(used.batches.batches().size(), fresh.batches.batches().size());
}

}  // namespace
}  // namespace wells
