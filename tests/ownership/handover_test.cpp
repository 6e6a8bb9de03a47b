#include "ownership/handover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "math/elementary.h"

namespace wells {
namespace {

constexpr HandoverRule kRule{.ratio = 0.9, .margin = 0.5, .dwell = 6};
const std::vector<PeerWell> kTwo{{PeerId{1}, {0, 0, 0}}, {PeerId{2}, {20, 0, 0}}};

// On the line between the wells, d2 < 0.9 d1 - 0.5 with d1 = x, d2 = 20 - x: x > 20.5 / 1.9.
TEST(Handover, AnotherWellMustBeNearerByTheMargin) {
  const double border = 20.5 / 1.9;
  EXPECT_EQ(nearerPeer({10.1, 0, 0}, PeerId{1}, kTwo, kRule), kNobody);
  EXPECT_EQ(nearerPeer({border - 1e-9, 0, 0}, PeerId{1}, kTwo, kRule), kNobody);
  EXPECT_EQ(nearerPeer({border + 1e-9, 0, 0}, PeerId{1}, kTwo, kRule), PeerId{2});
  EXPECT_EQ(nearerPeer({border + 1e-9, 0, 0}, PeerId{2}, kTwo, kRule), kNobody);
}

TEST(Handover, ATieGoesToTheLowestIdInAnyOrder) {
  std::vector<PeerWell> wells{{PeerId{1}, {50, 0, 0}},
                              {PeerId{2}, {1, 0, 0}},
                              {PeerId{3}, {-1, 0, 0}},
                              {PeerId{4}, {0, 0, 1}},
                              {PeerId{5}, {0, 0, -1}}};
  do {
    EXPECT_EQ(nearerPeer(Vec3::Zero(), PeerId{1}, wells, kRule), PeerId{2});
    EXPECT_EQ(nearerPeer(Vec3::Zero(), PeerId{4}, wells, kRule), kNobody) << "as near as any";
  } while (std::ranges::next_permutation(wells, {}, &PeerWell::peer).found);
}

TEST(Handover, WithoutAWellOfItsOwnAPeerGivesToTheNearest) {
  EXPECT_EQ(nearerPeer({1, 0, 0}, PeerId{3}, kTwo, kRule), PeerId{1});
  EXPECT_EQ(nearerPeer({1, 0, 0}, PeerId{3}, {}, kRule), kNobody);
}

TEST(Handover, MustLastForTheDwell) {
  HandoverWatch w = watch({}, PeerId{2}, 100);
  EXPECT_FALSE(isDue(w, 105, kRule));
  EXPECT_TRUE(isDue(w, 106, kRule));
  w = watch(w, kNobody, 104);
  w = watch(w, PeerId{2}, 105);
  EXPECT_FALSE(isDue(w, 106, kRule)) << "interrupted";
  EXPECT_FALSE(isDue({}, 1000, kRule)) << "nobody is nearer";
}

// A ball that swings about the border by `amplitude` for 60 periods of 120 steps.
int handovers(double amplitude) {
  PeerId owner{1};
  HandoverWatch w;
  int count = 0;
  for (std::int64_t step = 0; step < 60 * 120; ++step) {
    const double x = 10 + amplitude * sinCosOfTurns(static_cast<double>(step) / 120).sin;
    w = watch(w, nearerPeer({x, 0, 0}, owner, kTwo, kRule), step);
    if (!isDue(w, step, kRule)) continue;
    owner = w.nearer;
    w = {};
    ++count;
  }
  return count;
}

TEST(Handover, ABallOnTheBorderIsHandedOnOncePerCrossingOfTheBand) {
  const double halfBand = 20.5 / 1.9 - 10;
  EXPECT_EQ(handovers(0.99 * halfBand), 0);
  EXPECT_EQ(handovers(2 * halfBand), 2 * 60);
}

}  // namespace
}  // namespace wells
