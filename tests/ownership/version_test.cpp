#include "ownership/version.h"

#include <gtest/gtest.h>

#include <vector>

namespace wells {
namespace {

TEST(Generation, NoneIsLessThanAnyThenResetsThenTheEarlierFoundingThenTheNonce) {
  const std::vector<Generation> rising{
      {},          {0, 200, 9},  {0, 100, 1}, {0, 100, 2},
      {1, 900, 0}, {1, 300, -5}, {1, 300, 5}, {2, 999, 0},
  };
  for (std::size_t i = 0; i < rising.size(); ++i)
    for (std::size_t j = 0; j < rising.size(); ++j) {
      EXPECT_EQ(rising[i] < rising[j], i < j) << i << " and " << j;
      EXPECT_EQ(rising[i] == rising[j], i == j) << i << " and " << j;
    }
}

// Each member outweighs all that stand behind it.
TEST(Version, ComparesItsMembersInTheirOrder) {
  const Incarnation low{PeerId{1}, 10}, high{PeerId{2}, 5};
  const Version base{{0, 100, 1}, 1, low, 1, low, 1};
  const Version last{{0, 100, 1}, 1, low, 1, low, 9};
  const Version owner{{0, 100, 1}, 1, low, 1, high, 0};
  const Version epoch{{0, 100, 1}, 1, low, 2, low, 0};
  const Version adopter{{0, 100, 1}, 1, high, 0, low, 0};
  const Version term{{0, 100, 1}, 2, {}, 0, {}, 0};
  const Version generation{{0, 99, 0}, 0, {}, 0, {}, 0};
  const std::vector<Version> rising{base, last, owner, epoch, adopter, term, generation};
  for (std::size_t i = 0; i + 1 < rising.size(); ++i) EXPECT_LT(rising[i], rising[i + 1]) << i;
}

TEST(Version, IncarnationsOfOnePeerAreDifferentOwners) {
  EXPECT_NE((Incarnation{PeerId{1}, 10}), (Incarnation{PeerId{1}, 11}));
}

TEST(Version, ATenureIsAllButOwnerAndStep) {
  const Incarnation a{PeerId{1}, 10}, b{PeerId{2}, 20};
  const Version version{{0, 100, 1}, 1, a, 1, a, 1};
  Version other = version;
  other.step = 7;
  other.owner = b;
  EXPECT_TRUE(sameTenure(version, other));
  other.epoch = 2;
  EXPECT_FALSE(sameTenure(version, other));
  other = version;
  other.adopter.number = 11;
  EXPECT_FALSE(sameTenure(version, other));
}

}  // namespace
}  // namespace wells
