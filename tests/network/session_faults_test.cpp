// The session on bad networks, with peers that die, stall and come back, and with messages that
// are damaged or old.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "network/session_recorder.h"

namespace wells {
namespace {

constexpr MemoryFaults kBadNetwork{.loss = 0.2, .duplication = 0.2, .delay = 0.05, .jitter = 0.1};

TEST(SessionFaults, ConvergesOnABadNetwork) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Group group(60, seed, kBadNetwork);
    for (int id = 1; id <= 4; ++id) group.add(testOptions(id, seed * 100));
    ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 30)) << "seed " << seed;
    group.run(20);
    std::int64_t taken = 0;
    for (const auto& peer : group.peers()) taken += peer->session->counts().balls.handoversTaken;
    EXPECT_GT(taken, 30) << "seed " << seed;
    ASSERT_TRUE(group.settle(15)) << "seed " << seed;
    EXPECT_TRUE(group.everyBallHasOneOwner()) << "seed " << seed;
    group.expectEqualViews();
  }
}

TEST(SessionFaults, AnOwnerThatDiesOnABadNetworkLosesNoBall) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Group group(60, seed, kBadNetwork);
    for (int id = 1; id <= 3; ++id) group.add(testOptions(id, seed * 100));
    ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 30)) << "seed " << seed;
    group.run(10);
    group.kill(*group.peers()[seed % 3]);
    EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease + 1))
        << "seed " << seed;
    ASSERT_TRUE(group.settle(15)) << "seed " << seed;
    EXPECT_TRUE(group.everyBallHasOneOwner()) << "seed " << seed;
    group.expectEqualViews();
  }
}

TEST(SessionFaults, WhoLeavesWhenAllAreCompleteChangesNobodysResults) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Group group(60, seed, kBadNetwork);
    for (int id = 1; id <= 4; ++id) group.add(testOptions(id, seed * 100));
    ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 30)) << "seed " << seed;
    group.run(5);
    std::int64_t last = 0;
    for (const auto& peer : group.peers()) last = std::max(last, peer->world.step);
    for (const auto& peer : group.peers()) peer->session->stopAt(last + 30);

    using Owners = std::vector<std::pair<PeerId, std::size_t>>;
    std::map<PeerId, Owners> results;  // when each was complete
    const auto allHaveLeft = [&] {
      std::vector<TestPeer*> leaving;
      for (const auto& peer : group.peers()) {
        if (!peer->session->isComplete(peer->world)) continue;
        results.emplace(peer->session->peer(), peer->session->ballsOwned());
        if (peer->session->areOthersComplete(group.timesOf(*peer))) leaving.push_back(peer.get());
      }
      for (TestPeer* peer : leaving) {
        peer->session->leave(peer->world, group.timesOf(*peer));
        group.kill(*peer);
      }
      return group.peers().empty();
    };
    EXPECT_TRUE(group.runUntil(allHaveLeft, 10)) << "seed " << seed;
    ASSERT_EQ(results.size(), 4u) << "seed " << seed;
    for (const auto& [peer, owners] : results)
      EXPECT_EQ(owners, results.begin()->second) << "seed " << seed << ", peer " << value(peer);
  }
}

void cut(Group& group, int from, int to, MemoryLink link) {
  const auto endpoint = [&](int i) {
    return group.peers()[static_cast<std::size_t>(i)]->transport->endpoint();
  };
  group.network().setLink(endpoint(from), endpoint(to), link);
}

TEST(SessionFaults, TheHalvesOfAPartitionCarryOnAndAgreeWithinTwoLeasesOfItsHealing) {
  Group group(60);
  for (int id = 1; id <= 4; ++id) group.add(testOptions(id));
  group.run(10);
  const auto split = [&](MemoryLink link) {
    for (int a : {0, 1})
      for (int b : {2, 3}) {
        cut(group, a, b, link);
        cut(group, b, a, link);
      }
  };
  split(MemoryLink::Cut);
  group.run(10);
  for (std::size_t i = 0; i < group.balls(); ++i) EXPECT_EQ(group.ownersOf(i), 2) << "ball " << i;
  split(MemoryLink::Up);
  EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease));
  ASSERT_TRUE(group.settle(10));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

TEST(SessionFaults, APeerThatHearsButIsNotHeardDoesNoHarm) {
  Group group(60);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
  group.run(10);
  for (int other : {0, 1}) cut(group, 2, other, MemoryLink::Cut);
  EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease));
  EXPECT_GT(group.peers()[2]->session->records().size(), 0u);
  group.run(5);
  for (int other : {0, 1}) cut(group, 2, other, MemoryLink::Up);
  group.run(2 * kLease);
  ASSERT_TRUE(group.settle(10));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

// Each half has adopted the other's balls when one stalls, unheard: its records are greater than
// what the other publishes, and their owner, its former incarnation, will never speak again.
TEST(SessionFaults, AStalledPeerWhoseRecordsNobodyElseKnowsComesBack) {
  Group group(60);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  group.run(10);
  for (int a : {0, 1}) cut(group, a, 1 - a, MemoryLink::Cut);
  group.run(2 * kLease);
  TestPeer& stalled = *group.peers()[1];
  EXPECT_EQ(stalled.owned(), 60u);
  cut(group, 0, 1, MemoryLink::Up);
  group.run(0.2);
  stalled.isStalled = true;
  cut(group, 1, 0, MemoryLink::Up);
  group.run(1.5);
  stalled.isStalled = false;
  group.run(1);
  EXPECT_EQ(stalled.session->counts().fences, 1);
  EXPECT_TRUE(group.runUntil([&] { return group.allActive(); }, 3));
  EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease));
  ASSERT_TRUE(group.settle(10));
  group.expectEqualViews();
}

// Peer 1 offers balls to peer 2, who does not hear it; peer 3, whose well is far away, does.
TEST(SessionFaults, AnOfferThatItsReceiverMissesIsPassedOnByWhoHeardIt) {
  Group group(60);
  for (int id = 1; id <= 3; ++id) {
    SessionOptions options = testOptions(id);
    if (id == 3) options.well = restingWell({0, 0.5, 1000}, 0);
    group.add(options);
  }
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 10));
  group.run(5);
  ASSERT_EQ(group.peers()[2]->owned(), 0u);
  cut(group, 0, 1, MemoryLink::Cut);
  const Session& receiver = *group.peers()[1]->session;
  const std::int64_t before = receiver.counts().balls.handoversTaken;
  group.run(1.8);  // within the lease
  EXPECT_GT(receiver.counts().balls.handoversTaken, before);
  for (const auto& peer : group.peers()) EXPECT_EQ(peer->session->counts().balls.adoptions, 0);
}

TEST(SessionFaults, TwoSessionsThatMeetBecomeTheOneThatWasFoundedEarlier) {
  Group group(60);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  for (int a : {0, 1}) cut(group, a, 1 - a, MemoryLink::Cut);
  group.peers()[0]->isStalled = true;
  group.run(1);
  group.peers()[0]->isStalled = false;
  group.run(10);
  const Generation earlier = group.peers()[1]->session->generation();
  ASSERT_GT(earlier, group.peers()[0]->session->generation());
  for (int a : {0, 1}) cut(group, a, 1 - a, MemoryLink::Up);
  group.run(5);
  EXPECT_TRUE(group.allActive());
  for (const auto& peer : group.peers()) EXPECT_EQ(peer->session->generation(), earlier);
  EXPECT_EQ(group.peers()[0]->session->counts().resyncs, 1);
  ASSERT_TRUE(group.settle(10));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

TEST(SessionFaults, APeerThatSyncsWhenEverybodyElseVanishesTakesWhatItHolds) {
  Group group(60);
  TestPeer& first = group.add(testOptions(1));
  group.run(10);
  TestPeer& late = group.add(testOptions(2));
  ASSERT_TRUE(group.runUntil([&] { return late.session->phase() == Phase::Syncing; }, 6));
  group.kill(first);
  EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 4 * kLease));
  EXPECT_EQ(late.session->phase(), Phase::Active);
  EXPECT_EQ(late.owned(), 60u);
}

TEST(SessionFaults, AStalledOwnerFencesItselfBeforeItSendsAnything) {
  for (const double stall : {1.2, 5.0}) {  // shorter and longer than the lease
    Group group(60);
    for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
    group.run(12);
    TestPeer& stalled = *group.peers()[1];
    const std::int64_t before = stalled.session->self().number;
    ASSERT_GT(stalled.owned(), 0u);
    stalled.isStalled = true;
    group.run(stall);
    Recorder recorder(group);
    stalled.isStalled = false;
    group.run(10);
    EXPECT_EQ(stalled.session->counts().fences, 1);
    EXPECT_NE(stalled.session->self().number, before);
    recorder.record();
    for (const auto& [channel, bytes] : recorder.messages()) {
      const auto decoded = decode(channel, bytes, {.balls = 60});
      EXPECT_NE(headerOf(std::get<Message>(decoded)).incarnation, before);
    }
    EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 0.1));
    EXPECT_TRUE(group.allActive());
    ASSERT_TRUE(group.settle(5));
    group.expectEqualViews();
  }
}

TEST(SessionFaults, AShortStallIsNoReasonToFence) {
  Group group(60);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  group.run(10);
  group.peers()[0]->isStalled = true;
  group.run(0.8);
  group.peers()[0]->isStalled = false;
  group.run(5);
  for (const auto& peer : group.peers()) {
    EXPECT_EQ(peer->session->counts().fences, 0);
    EXPECT_EQ(peer->session->counts().balls.adoptions, 0);
  }
}

TEST(SessionFaults, ALonePeerThatStallsKeepsItsBalls) {
  Group group(25);
  TestPeer& peer = group.add(testOptions(1));
  group.run(6);
  peer.isStalled = true;
  group.run(60);
  peer.isStalled = false;
  group.run(0.1);
  EXPECT_EQ(peer.session->phase(), Phase::Active);
  EXPECT_EQ(peer.owned(), 25u);
  EXPECT_EQ(peer.session->counts().fences, 1);
}

TEST(SessionFaults, ALogPlayedBackChangesNothingAndIsCounted) {
  Group group(60);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
  Recorder recorder(group);
  group.run(10);
  group.kill(*group.peers()[2]);
  group.run(2 * kLease);
  ASSERT_TRUE(group.settle(5));
  recorder.record();
  const auto before = snapshot(group);
  const auto living = group.peers()[0]->session->livingPeers(group.timesOf(*group.peers()[0]));
  std::vector<std::int64_t> drops;
  for (const auto& peer : group.peers()) drops.push_back(peer->session->counts().drops.total());

  ASSERT_GT(recorder.messages().size(), 2000u);
  for (const auto& [channel, bytes] : recorder.messages()) recorder.send(channel, bytes);
  group.run(1);
  EXPECT_EQ(snapshot(group), before);
  EXPECT_EQ(group.peers()[0]->session->livingPeers(group.timesOf(*group.peers()[0])), living);
  for (std::size_t i = 0; i < group.peers().size(); ++i) {
    const SessionCounts counts = group.peers()[i]->session->counts();
    EXPECT_GT(counts.drops[Drop::Replayed], 1000);
    EXPECT_GT(counts.drops.total(), drops[i]);
  }
}

TEST(SessionFaults, AnOldLogChangesNothingForOneWhoHasForgottenItsSenders) {
  Group group(60);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  Recorder recorder(group);
  group.run(10);
  recorder.record();
  group.kill(*group.peers()[1]);
  group.run(2 * kLease + 70);  // far more than the clock tolerance
  ASSERT_TRUE(group.settle(5));
  group.run(1);  // so that the last states are published, too
  const auto before = snapshot(group);
  for (const auto& [channel, bytes] : recorder.messages()) recorder.send(channel, bytes);
  group.run(1);
  EXPECT_EQ(snapshot(group), before);
  EXPECT_GT(group.peers()[0]->session->counts().drops[Drop::ClockApart], 500);
}

TEST(SessionFaults, DamagedMessagesChangeNothingAndAreCounted) {
  Group group(60);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  Recorder recorder(group);
  group.run(8);
  ASSERT_TRUE(group.settle(5));
  recorder.record();
  const auto before = snapshot(group);
  Random random(3);
  const auto garble = [&](std::vector<std::byte>& bytes, std::size_t offset, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes[offset + i] = std::byte{0xff};
  };
  for (int i = 0; i < 3000; ++i) {
    const auto& [channel, bytes] = recorder.messages()[random.below(recorder.messages().size())];
    auto damaged = bytes;
    switch (random.below(5)) {
      case 0:
        damaged.resize(random.below(damaged.size()));
        break;
      case 1:
        damaged.resize(damaged.size() + 1 + random.below(1000));
        break;
      case 2:
        garble(damaged, random.below(8), 1 + random.below(8));
        break;  // the fingerprint
      case 3:
        garble(damaged, 80, 4);
        break;  // a count, where there is one
      default:
        garble(damaged, damaged.size() - 8, 8);  // where there are balls: NaN
    }
    if (damaged != bytes) recorder.send(channel, damaged);
  }
  group.run(1);
  EXPECT_EQ(snapshot(group), before);
  const DropCounts drops = group.peers()[0]->session->counts().drops;
  EXPECT_GT(drops[Drop::WrongSize], 0);
  EXPECT_GT(drops[Drop::BadCount], 0);
  EXPECT_GT(drops[Drop::Undecodable], 0);
  EXPECT_GT(drops[Drop::OutOfRange], 0);
  EXPECT_GT(drops.total(), 2000);
}

/// WELLS_SOAK=<n>: so many times the seeds.
std::uint64_t soak() {
  const char* factor = std::getenv("WELLS_SOAK");
  return factor ? std::strtoull(factor, nullptr, 10) : 1;
}

// All that can happen, at random, to a group of three to five; then it heals and must agree.
TEST(SessionFaults, RandomFaultsNeverBreakAPromise) {
  for (std::uint64_t seed = 1; seed <= 8 * soak(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Group group(40, seed,
                {.loss = random.uniform(0, 0.3),
                 .duplication = random.uniform(0, 0.5),
                 .delay = random.uniform(0, 0.05),
                 .jitter = random.uniform(0, 0.1)});
    std::uint64_t starts = seed * 100;
    for (int id = 1; id <= 3; ++id) group.add(testOptions(id, ++starts));
    for (int event = 0; event < 25; ++event) {
      group.run(random.uniform(0.2, 4));
      auto& peers = group.peers();
      TestPeer& peer = *peers[random.below(peers.size())];
      switch (random.below(6)) {
        case 0:
          if (peers.size() > 1) group.kill(peer);
          break;
        case 1:
          if (peers.size() < 5)
            group.add(testOptions(1 + static_cast<int>(random.below(5)), ++starts)).clockOffset =
                random.uniform(-10, 10);
          break;
        case 2:
          peer.isStalled = true;
          break;
        case 3:
          peer.isStalled = false;
          break;
        default: {
          const auto a = static_cast<int>(random.below(peers.size()));
          const auto b = static_cast<int>(random.below(peers.size()));
          cut(group, a, b, random.below(3) == 0 ? MemoryLink::Cut : MemoryLink::Up);
        }
      }
      if (testing::Test::HasFatalFailure()) return;
    }
    const auto count = static_cast<int>(group.peers().size());
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < count; ++b) cut(group, a, b, MemoryLink::Up);
    for (const auto& peer : group.peers()) peer->isStalled = false;
    group.network().setFaults({});
    group.run(1);  // until those that were stalled have noticed
    ASSERT_TRUE(group.runUntil([&] { return group.allActiveInOneGeneration(); }, 40));
    // Two leases, and the time that an offer under way takes.
    EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease + 0.1));
    ASSERT_TRUE(group.settle(15));
    EXPECT_TRUE(group.everyBallHasOneOwner());
    group.expectEqualViews();
  }
}

}  // namespace
}  // namespace wells
