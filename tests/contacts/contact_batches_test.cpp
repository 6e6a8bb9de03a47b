#include "contacts/contact_batches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

using Ids = std::vector<std::uint32_t>;

constexpr std::size_t kIdle = 2;

/// A crowd whose balls are the ids `order`, in that order.
struct Split {
  Split(Ids order, std::vector<BallPair> given) : balls(std::move(order)), pairs(std::move(given)) {
    place.resize(balls.empty() ? 0 : *std::ranges::max_element(balls) + 1);
    for (std::uint32_t k = 0; k < balls.size(); ++k) place[balls[k]] = k;
    for (const auto& [a, b] : pairs)
      if (isBall(b))
        near.push_back({place[a], place[b]});
      else
        ofArena.push_back({a, b});
    std::ranges::sort(near, [](const IndexPair& x, const IndexPair& y) {
      return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    for (std::uint32_t k = 0; k <= balls.size(); ++k)
      firstOf.push_back(static_cast<std::uint32_t>(
          std::ranges::lower_bound(near, k, {}, &IndexPair::a) - near.begin()));
    splitInto(batches, pool);
  }

  void splitInto(ContactBatches& into, ThreadPool& threads) const {
    into.split({near, firstOf}, ofArena, place, kIdle, threads);
  }

  std::uint32_t arena() const { return static_cast<std::uint32_t>(balls.size()); }
  /// The numbers of all pairs of a batch.
  Ids numbersOf(const ContactBatch& batch) const {
    Ids numbers(batch.last - batch.first);
    std::iota(numbers.begin(), numbers.end(), batch.first);
    if (batch.of == ContactBatch::Of::Late)
      for (std::uint32_t& n : numbers) n = batches.late()[n];
    return numbers;
  }
  std::vector<IndexPair> pairsOf(const ContactBatch& batch) const {
    std::vector<IndexPair> found;
    for (const std::uint32_t n : numbersOf(batch)) found.push_back(batches.pairs()[n]);
    return found;
  }
  /// The number of a pair given.
  std::uint32_t find(const BallPair& pair) const {
    return batches.find(place[pair.a], isBall(pair.b) ? place[pair.b] : pair.b);
  }

  Ids balls;
  std::vector<BallPair> pairs;
  std::vector<IndexPair> near;
  Ids firstOf;
  std::vector<BallPair> ofArena;
  Ids place;
  ThreadPool pool;
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
std::unique_ptr<Split> randomCrowd(std::uint64_t seed, std::uint32_t count) {
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
  return std::make_unique<Split>(std::move(balls), std::move(pairs));
}

void expectEachPairOnce(const Split& crowd) {
  const auto placed = crowd.batches.pairs();
  ASSERT_EQ(crowd.batches.firstIdle(), crowd.pairs.size());
  ASSERT_EQ(crowd.batches.firstLate(), crowd.pairs.size() + kIdle);
  Ids found;
  for (const BallPair& pair : crowd.pairs) {
    const std::uint32_t n = crowd.find(pair);
    ASSERT_LT(n, crowd.pairs.size());
    EXPECT_EQ(placed[n].a, crowd.place[pair.a]);
    EXPECT_EQ(placed[n].b, isBall(pair.b) ? crowd.place[pair.b] : crowd.arena());
    found.push_back(n);
  }
  std::ranges::sort(found);
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
  std::uint32_t end = 0;
  for (const ContactBatch& batch : crowd.batches.batches()) {
    if (batch.of == ContactBatch::Of::Late) continue;
    EXPECT_EQ(batch.first, end);
    EXPECT_LT(batch.first, batch.last);
    end = batch.last;
  }
  EXPECT_EQ(end, crowd.pairs.size());
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
      if (batch.of == ContactBatch::Of::Late) continue;
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
  std::map<std::uint32_t, std::uint32_t> partnerAt;
  for (const BallPair& pair : crowd.pairs) partnerAt[crowd.find(pair)] = pair.b;
  for (const ContactBatch& batch : crowd.batches.batches()) {
    if (batch.of == ContactBatch::Of::Late) continue;
    for (const std::uint32_t n : crowd.numbersOf(batch)) {
      const std::uint32_t b = partnerAt[n];
      const PartnerKind kind = isBall(b)      ? PartnerKind::Ball
                               : b == kGround ? PartnerKind::Ground
                                              : PartnerKind::Wall;
      EXPECT_EQ(batch.partner, kind);
    }
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
    const auto crowd = randomCrowd(count, count);
    EXPECT_EQ(crowd->batches.tiles(), (count + 511) / 512);
    expectWellSplit(*crowd);
    if (testing::Test::HasFailure()) FAIL() << count << " balls";
  }
}

TEST(ContactBatches, OfNothingAreNone) {
  const Split nobody({}, {});
  EXPECT_TRUE(nobody.batches.batches().empty());
  EXPECT_EQ(nobody.batches.firstIdle(), 0u);
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
  const auto crowd = randomCrowd(7, 512);
  std::vector<std::size_t> contacts(crowd->balls.size());
  std::size_t most = 0;
  for (const auto& [a, b] : crowd->near) most = std::max({most, ++contacts[a], ++contacts[b]});
  ASSERT_LT(2 * most, 64u);
  EXPECT_LE(crowd->batches.batches().size(), 2 * most - 1 + 2);
}

void expectSame(const ContactBatches& some, const ContactBatches& others) {
  ASSERT_EQ(some.firstIdle(), others.firstIdle());
  for (std::uint32_t n = 0; n < some.firstIdle(); ++n) {
    EXPECT_EQ(some.pairs()[n].a, others.pairs()[n].a);
    EXPECT_EQ(some.pairs()[n].b, others.pairs()[n].b);
  }
  ASSERT_EQ(some.batches().size(), others.batches().size());
  for (std::size_t n = 0; n < some.batches().size(); ++n)
    EXPECT_EQ(some.batches()[n].last, others.batches()[n].last);
}

TEST(ContactBatches, ForgetTheCrowdBefore) {
  const auto crowd = randomCrowd(3, 3000);
  const auto fresh = randomCrowd(4, 700);
  fresh->splitInto(crowd->batches, crowd->pool);
  expectSame(crowd->batches, fresh->batches);
}

TEST(ContactBatches, AreTheSameForAnyNumberOfThreads) {
  const auto crowd = randomCrowd(5, 9000);
  for (const int threads : {2, 3}) {
    ThreadPool pool(threads);
    ContactBatches batches;
    crowd->splitInto(batches, pool);
    expectSame(batches, crowd->batches);
  }
}

// Those of a random crowd, every third of which touches.
TEST(ContactBatches, HaveLatePairsBeforeTheArena) {
  const auto crowd = randomCrowd(6, 2000);
  const std::size_t before = crowd->batches.batches().size();
  const auto others = randomCrowd(7, 2000);
  Ids touching;
  for (std::size_t n = 0; n < others->near.size(); ++n) {
    crowd->batches.add(others->near[n]);
    if (n % 3 == 0) touching.push_back(crowd->batches.firstLate() + static_cast<std::uint32_t>(n));
  }
  crowd->batches.setLate(touching);
  expectWellSplit(*crowd);
  Ids late;
  for (const ContactBatch& batch : crowd->batches.batches()) {
    if (batch.of == ContactBatch::Of::Pairs) continue;
    const Ids numbers = crowd->numbersOf(batch);
    late.insert(late.end(), numbers.begin(), numbers.end());
  }
  std::ranges::sort(late);
  EXPECT_EQ(late, touching);

  crowd->batches.setLate({});
  EXPECT_EQ(crowd->batches.batches().size(), before);
}

}  // namespace
}  // namespace wells
