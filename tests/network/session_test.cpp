// The session on a network in memory, with good links: founding, joining, hand-over, adoption.
#include "network/session.h"

#include <gtest/gtest.h>

#include "network/session_group.h"

namespace wells {
namespace {

TEST(Session, FoundsAloneAfterListeningForTwoLeases) {
  Group group(25);
  TestPeer& peer = group.add(testOptions(1));
  group.run(2 * kLease - 0.1);
  EXPECT_EQ(peer.session->phase(), Phase::Joining);
  EXPECT_EQ(peer.owned(), 0u);
  EXPECT_EQ(peer.world.step, 0);
  group.run(0.2);
  EXPECT_EQ(peer.session->phase(), Phase::Active);
  EXPECT_EQ(peer.owned(), 25u);
  const std::int64_t before = peer.world.step;
  group.run(1);
  EXPECT_NEAR(static_cast<double>(peer.world.step - before), 60, 1);
}

TEST(Session, StartersAtTheSameTimeEndInOneGeneration) {
  Group group(25);
  for (int id = 1; id <= 4; ++id) group.add(testOptions(id));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 3 * kLease + 3));
  for (const auto& peer : group.peers()) {
    EXPECT_EQ(peer->session->generation(), group.peers()[0]->session->generation());
    EXPECT_EQ(peer->session->counts().resyncs, 0);
  }
  group.run(2);
  EXPECT_TRUE(group.settle(5));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

TEST(Session, BallsFollowTheNearestWellAndAllViewsAgreeToTheBit) {
  Group group(100);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 10));
  group.run(20);
  std::int64_t given = 0;
  for (const auto& peer : group.peers()) {
    EXPECT_GT(peer->owned(), 0u);
    given += peer->session->counts().balls.handoversGiven;
    EXPECT_EQ(peer->session->counts().drops.total(), 0);
  }
  EXPECT_GT(given, 100);
  ASSERT_TRUE(group.settle(5));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

}  // namespace
}  // namespace wells
