// Who a peer is: ids that are taken, worlds that differ, clocks that are off.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "network/session_group.h"

namespace wells {
namespace {

TEST(SessionIdentity, TheLaterOfTwoEqualIdsTakesTheLowestFreeOne) {
  Group group(25);
  group.add(testOptions(1));
  group.run(6);
  group.add(testOptions(2));
  group.run(6);
  TestPeer& twin = group.add(testOptions(1, 1));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 12));
  EXPECT_EQ(twin.session->peer(), PeerId{3});
  ASSERT_FALSE(twin.notices.empty());
  EXPECT_NE(twin.notices.front().find("takes id 3"), std::string::npos) << twin.notices.front();
  EXPECT_EQ(group.peers()[0]->session->counts().fences, 0);
  group.run(2);
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
}

TEST(SessionIdentity, OfTwoJoinersWithOneIdTheFirstToStartKeepsIt) {
  Group group(25);
  TestPeer& first = group.add(testOptions(1));
  group.run(1);
  TestPeer& second = group.add(testOptions(1, 1));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 15));
  EXPECT_EQ(first.session->peer(), PeerId{1});
  EXPECT_EQ(second.session->peer(), PeerId{2});
}

TEST(SessionIdentity, AWholeLabWithOneTemplateFindsIdsForAll) {
  Group group(25);
  for (std::uint64_t i = 0; i < 6; ++i) group.add(testOptions(1, i));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 40));
  std::set<PeerId> ids;
  for (const auto& peer : group.peers()) ids.insert(peer->session->peer());
  EXPECT_EQ(ids.size(), 6u);
  EXPECT_EQ(*ids.rbegin(), PeerId{6});
  group.run(5);
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
}

TEST(SessionIdentity, AnExplicitIdThatIsTakenIsAnError) {
  Group group(25);
  group.add(testOptions(1));
  group.run(6);
  SessionOptions options = testOptions(1, 1);
  options.idChoice = PeerIdChoice::Explicit;
  group.add(options);
  try {
    group.run(6);
    FAIL() << "nothing was thrown";
  } catch (const PeerIdTaken& error) {
    EXPECT_NE(std::string(error.what()).find("peer id 1 is in use"), std::string::npos);
  }
  EXPECT_EQ(group.peers()[0]->session->counts().fences, 0);
}

TEST(SessionIdentity, AJoinerOfAnotherWorldIsToldTheKeyThatDiffersAndTheOthersGoOn) {
  Group group(25);
  group.add(testOptions(1));
  group.run(6);
  SessionOptions options = testOptions(2);
  options.canonicalConfig = "BallRadius=0.6\nNumOfBalls=many\n";
  options.worldHash = 43;
  TestPeer& foreign = group.add(options);
  try {
    group.run(6);
    FAIL() << "nothing was thrown";
  } catch (const WorldMismatch& error) {
    EXPECT_STREQ(error.what(),
                 "peer 1 simulates another world: BallRadius is 0.5 there and 0.6 here");
  }
  EXPECT_EQ(foreign.session->phase(), Phase::Joining);
  const TestPeer& first = *group.peers()[0];
  ASSERT_EQ(first.notices.size(), 2u);
  EXPECT_NE(first.notices[1].find("BallRadius is 0.6 there and 0.5 here; it is ignored"),
            std::string::npos)
      << first.notices[1];
  EXPECT_GT(first.session->counts().drops[Drop::ForeignWorld], 0);
}

TEST(SessionIdentity, AMachineWhoseClockIsFarOffIsIgnoredAndNamed) {
  Group group(25);
  group.add(testOptions(1));
  group.run(6);
  TestPeer& off = group.add(testOptions(2));
  off.clockOffset = 3600;
  group.run(6);
  const TestPeer& first = *group.peers()[0];
  EXPECT_EQ(first.session->livingPeers(group.timesOf(first)).size(), 1u);
  EXPECT_GT(first.session->counts().drops[Drop::ClockApart], 0);
  EXPECT_NE(first.notices.back().find("3599 s ahead of ours"), std::string::npos)
      << first.notices.back();
}

TEST(SessionIdentity, ClocksTenSecondsApartDoNoHarm) {
  Group group(50);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id)).clockOffset = 10.0 * (id - 2);
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 15));
  group.run(5);
  ASSERT_TRUE(group.settle(5));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

}  // namespace
}  // namespace wells
