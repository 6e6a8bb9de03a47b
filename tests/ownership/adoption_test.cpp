#include "ownership/adoption.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

TEST(Adoption, RanksTheLivingByDistanceThenById) {
  const std::vector<PeerWell> wells{
      {PeerId{1}, {3, 0, 0}}, {PeerId{2}, {1, 0, 0}}, {PeerId{3}, {-1, 0, 0}}};
  const Vec3 ball = Vec3::Zero();
  EXPECT_EQ(adoptionRank(ball, PeerId{2}, wells), 0u);
  EXPECT_EQ(adoptionRank(ball, PeerId{3}, wells), 1u);
  EXPECT_EQ(adoptionRank(ball, PeerId{1}, wells), 2u);
  EXPECT_EQ(adoptionRank(ball, PeerId{9}, wells), 3u) << "without a well: last";
}

TEST(Adoption, EveryRankIsGivenOnce) {
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    std::vector<PeerWell> wells;
    // Whole numbers, so that distances are often equal.
    for (int id = 1; id <= 6; ++id)
      wells.push_back({PeerId{id}, Vec3{static_cast<double>(random.below(3)), 0, 0}});
    std::set<std::size_t> ranks;
    for (const PeerWell& well : wells) ranks.insert(adoptionRank({1, 0, 0}, well.peer, wells));
    EXPECT_EQ(ranks.size(), wells.size());
    EXPECT_EQ(*ranks.rbegin(), wells.size() - 1);
  }
}

TEST(Adoption, TheFirstAdoptsAtOnceAndTheLastWithinOneMoreLease) {
  for (std::size_t candidates = 1; candidates <= 255; ++candidates) {
    EXPECT_EQ(adoptionWait(0, candidates, 2), 0);
    for (std::size_t rank = 1; rank < candidates; ++rank)
      EXPECT_GT(adoptionWait(rank, candidates, 2), adoptionWait(rank - 1, candidates, 2));
    EXPECT_LT(adoptionWait(candidates - 1, candidates, 2), 2);
  }
}

}  // namespace
}  // namespace wells
