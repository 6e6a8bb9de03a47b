// The session on a network in memory, with good links: founding, joining, hand-over, adoption.
#include "network/session.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

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

// Balls that meet nothing fly the same whoever owns them, and are predicted to the bit.
TEST(Session, AHandoverInFreeFlightLeavesNoTrace) {
  Group group(9);
  for (int id = 1; id <= 2; ++id) {
    SessionOptions options = testOptions(id);
    options.well = restingWell({id == 1 ? -12.0 : 12.0, 20, 0}, 10);
    TestPeer& peer = group.add(options);
    peer.world.settings.gravity = Vec3::Zero();
    for (std::size_t i = 0; i < 9; ++i) {
      const double z = 7 * (static_cast<double>(i) - 4);
      peer.world.balls.setState(i, {.position = {-15, 20, z}, .velocity = {5, 0, 0}});
    }
    peer.session.reset();
    peer.session = std::make_unique<Session>(options, peer.world, *peer.transport);
  }
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 10));
  group.run(1);  // both wells act
  World twin = group.peers()[0]->world;
  twin.roles.clear();
  const auto stepper = makeSimulation();
  std::int64_t given = 0;
  for (int i = 0; i < 300; ++i) {
    group.tick();
    for (const auto& peer : group.peers()) {
      if (peer->world.step < twin.step) continue;
      while (twin.step < peer->world.step) stepper->step(twin);
      for (std::size_t b = 0; b < 9; ++b)
        ASSERT_LE(length(peer->world.balls.position[b] - twin.balls.position[b]), 1e-9)
            << "ball " << b << " at step " << twin.step;
    }
  }
  for (const auto& peer : group.peers()) {
    given += peer->session->counts().balls.handoversGiven;
    EXPECT_LE(peer->session->viewDifference(), 1e-9);
  }
  EXPECT_GE(given, 9);
}

TEST(Session, AGroupAgreesOnEveryWellAtEveryStep) {
  Group group(25);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 10));
  group.run(1);
  for (int i = 0; i < 120; ++i) {
    group.tick();
    const World& first = group.peers()[0]->world;
    ASSERT_EQ(first.tracks.size(), 3u);
    for (const auto& peer : group.peers())
      for (std::size_t t = 0; t < 3; ++t) {
        const Well a = wellAt(first.tracks[t], first.step, kTick);
        const Well b = wellAt(peer->world.tracks[t], first.step, kTick);
        ASSERT_EQ(a.peer, b.peer);
        ASSERT_EQ(a.position, b.position);
        ASSERT_EQ(a.strength, b.strength);
      }
  }
}

// Nothing pulls and all balls lie on the ground. Each peer lets its own sleep and the others', and
// whoever moves one wakes it everywhere.
TEST(Session, BallsAtRestSleepWithAllPeersAndWakeWithTheirOwner) {
  Group group(25);
  for (int id = 1; id <= 2; ++id) {
    SessionOptions options = testOptions(id);
    options.well = restingWell({id == 1 ? -12.0 : 12.0, 0.5, 0}, 0);
    group.add(options);
  }
  group.run(40);
  for (const auto& peer : group.peers()) EXPECT_EQ(peer->stepper->counts().asleep, 25);
  group.run(5);
  for (const auto& peer : group.peers()) EXPECT_EQ(peer->stepper->counts().asleep, 25);

  TestPeer& owner = *group.peers()[0];
  TestPeer& other = *group.peers()[1];
  const auto ball = static_cast<std::size_t>(std::ranges::find(owner.world.roles, Role::Owned) -
                                             owner.world.roles.begin());
  const Vec3 start = owner.world.balls.position[ball];
  owner.world.setState(ball, {.position = start, .velocity = {2, 0, 0}});
  group.run(1);
  EXPECT_EQ(owner.stepper->counts().asleep, 24);
  EXPECT_EQ(other.stepper->counts().asleep, 24);
  EXPECT_GT(length(other.world.balls.position[ball] - start), 0.5);
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
}

// The wells go round, so that balls change hands; they do not pull.
TEST(Session, BallsAtRestStayWhereTheyAreWhoeverOwnsThem) {
  Group group(25);
  for (int id = 1; id <= 2; ++id) {
    SessionOptions options = testOptions(id);
    options.well = circlingWell(10, 0);
    group.add(options);
  }
  group.run(40);
  const std::vector<Vec3> before = group.peers()[0]->world.balls.position;
  const std::int64_t given = group.peers()[0]->session->counts().balls.handoversGiven;
  std::int64_t most = 0;
  for (int i = 0; i < 600; ++i) {
    group.tick();
    most = std::max(most, group.peers()[0]->stepper->counts().asleep);
  }
  EXPECT_GT(group.peers()[0]->session->counts().balls.handoversGiven, given + 10);
  EXPECT_GE(most, 20);
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
  EXPECT_EQ(group.peers()[0]->world.balls.position, before);
}

TEST(Session, TheViewDifferenceIsHowFarABallWasShownFromItsOwnersState) {
  Group group(25);
  for (int id = 1; id <= 2; ++id) {
    SessionOptions options = testOptions(id);
    options.well = restingWell({id == 1 ? -12.0 : 12.0, 0.5, 0}, 0);
    group.add(options);
  }
  group.run(30);  // until all balls are at rest
  // The one that is ahead: what comes to the other early is applied in time, and shown.
  const auto& peers = group.peers();
  TestPeer& peer = *peers[peers[0]->world.step >= peers[1]->world.step ? 0 : 1];
  const auto ghost = static_cast<std::size_t>(std::ranges::find(peer.world.roles, Role::Ghost) -
                                              peer.world.roles.begin());
  ASSERT_LT(ghost, group.balls());
  EXPECT_LT(peer.session->recentViewDifference(group.timesOf(peer)), 1e-9);
  peer.world.balls.position[ghost].x() += 0.25;
  const bool isFound = group.runUntil(
      [&] { return peer.session->recentViewDifference(group.timesOf(peer)) > 0.1; }, 1.1);
  EXPECT_TRUE(isFound);
  EXPECT_LE(peer.session->recentViewDifference(group.timesOf(peer)), 0.25 + 1e-9);
}

TEST(Session, KeepsFixedWellsAndForgetsOldKeyframes) {
  World world = testWorld(3);
  world.tracks = {{.keyframes = {{0, Vec3{1, 2, 3}, 5}}, .softening = 2, .peer = PeerId{9}}};
  const auto network = std::make_shared<MemoryNetwork>();
  MemoryTransport transport(network);
  SessionOptions options = testOptions(1);
  options.listen = 0;
  Session session(options, world, transport);
  const auto stepper = makeSimulation();
  for (int i = 0; i < 1200; ++i) {
    const Times now{i * kTick, 1'700'000'000'000'000 + i * 16'667};
    session.beforeStep(world, now);
    ASSERT_EQ(session.mayStep(world, now), 1);
    stepper->step(world);
    session.afterStep(world, now);
  }
  ASSERT_EQ(world.tracks.size(), 2u);
  EXPECT_EQ(world.tracks[0].peer, kNobody) << "a track of the initial world is a part of it";
  EXPECT_EQ(world.tracks[0].keyframes.size(), 1u);
  EXPECT_LT(world.tracks[1].keyframes.size(), 50u);
  EXPECT_LE(world.tracks[1].keyframes.front().step, world.step - 240);
}

TEST(Session, ALateJoinerIsActiveSoonAfterListeningAndHoldsTheOwnersStates) {
  Group group(200);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  group.run(15);
  TestPeer& late = group.add(testOptions(3));
  group.run(2 * kLease);
  ASSERT_TRUE(group.runUntil([&] { return late.session->phase() == Phase::Active; }, 3));
  const TestPeer& first = *group.peers()[0];
  EXPECT_NEAR(static_cast<double>(late.world.step), static_cast<double>(first.world.step), 4);
  EXPECT_EQ(late.session->generation(), first.session->generation());
  // Nobody has moved a ball further than its prediction errs in the second since it was published.
  for (std::size_t i = 0; i < group.balls(); ++i)
    EXPECT_LT(length(late.world.balls.position[i] - first.world.balls.position[i]), 2) << i;
  group.run(10);
  EXPECT_GT(late.owned(), 0u);
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
}

TEST(Session, TheBallsOfAKilledOwnerAreOwnedAgainWithinTwoLeases) {
  for (int survivors = 1; survivors <= 3; ++survivors) {
    Group group(100);
    for (int id = 1; id <= survivors + 1; ++id) group.add(testOptions(id));
    group.run(15);
    TestPeer& victim = *group.peers().back();
    ASSERT_GT(victim.owned(), 0u);
    group.kill(victim);
    EXPECT_FALSE(group.everyBallHasOneOwner());
    EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease));
    group.run(1);
    for (const auto& peer : group.peers()) {
      const auto pulling = std::ranges::count_if(peer->world.tracks, [&](const WellTrack& track) {
        return wellAt(track, peer->world.step, kTick).strength != 0;
      });
      EXPECT_EQ(pulling, survivors) << "its well is switched off";
    }
    ASSERT_TRUE(group.settle(5));
    EXPECT_TRUE(group.everyBallHasOneOwner());
    group.expectEqualViews();
  }
}

/// An elastic gas without gravity or friction, in which nothing but an impact changes a velocity
/// and nothing at all the kinetic energy.
void makeGas(World& world) {
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  Random random(5);
  for (Vec3& v : world.balls.velocity)
    v = {random.uniform(-3, 3), random.uniform(-1, 1), random.uniform(-3, 3)};
}

/// J, of the states of those who act as owners.
double kineticEnergy(Group& group) {
  double energy = 0;
  for (const auto& peer : group.peers())
    for (std::size_t i = 0; i < group.balls(); ++i)
      if (peer->world.roles[i] == Role::Owned)
        energy += 0.5 * peer->world.balls.mass[i] * squaredLength(peer->world.balls.velocity[i]);
  return energy;
}

TEST(Session, AdoptionLosesNoBallAndAddsNoKineticEnergy) {
  Group group(100, 1, {}, makeGas);
  for (int id = 1; id <= 3; ++id) {
    SessionOptions options = testOptions(id);
    options.well = restingWell({20.0 * (id - 2), 0.5, 0}, 0);
    group.add(options);
  }
  ASSERT_TRUE(group.runUntil([&] { return group.allActiveInOneGeneration(); }, 15));
  group.run(5);
  ASSERT_TRUE(group.everyBallHasOneOwner());
  const double before = kineticEnergy(group);
  ASSERT_GT(group.peers()[1]->owned(), 10u);
  group.kill(*group.peers()[1]);
  ASSERT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, 2 * kLease));
  EXPECT_NEAR(kineticEnergy(group) / before, 1, 1e-9);
  group.run(5);
  EXPECT_TRUE(group.everyBallHasOneOwner());
  EXPECT_NEAR(kineticEnergy(group) / before, 1, 1e-9);
}

TEST(Session, WhoLeavesIsNotWaitedFor) {
  Group group(100);
  for (int id = 1; id <= 3; ++id) group.add(testOptions(id));
  group.run(15);
  TestPeer& leaver = *group.peers().back();
  ASSERT_GT(leaver.owned(), 0u);
  leaver.session->leave(leaver.world, group.timesOf(leaver));
  group.kill(leaver);
  // The nearest at once, the next after a third of a lease at most.
  EXPECT_TRUE(group.runUntil([&] { return group.everyBallHasOneOwner(); }, kLease / 2));
  ASSERT_TRUE(group.settle(5));
  group.expectEqualViews();
}

TEST(Session, ARestartedPeerComesBackAsAnotherIncarnationAndGetsBallsAgain) {
  Group group(100);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  group.run(15);
  group.kill(*group.peers().back());
  group.run(0.5);
  TestPeer& again = group.add(testOptions(2, 1));
  ASSERT_TRUE(group.runUntil([&] { return again.session->phase() == Phase::Active; }, 10));
  EXPECT_EQ(again.session->peer(), PeerId{2});
  group.run(10);
  EXPECT_GT(again.owned(), 0u);
  ASSERT_TRUE(group.settle(5));
  EXPECT_TRUE(group.everyBallHasOneOwner());
  group.expectEqualViews();
}

TEST(Session, PeersThatStartSecondsApartKeepPace) {
  Group group(25);
  group.add(testOptions(1));
  group.run(10);
  group.add(testOptions(2));
  group.run(10);
  for (int i = 0; i < 600; ++i) {
    group.tick();
    const auto apart = group.peers()[0]->world.step - group.peers()[1]->world.step;
    ASSERT_LE(std::abs(apart), 4);
  }
}

TEST(Session, ThePeerThatIsSlowerHoldsTheOthersBackOnlySoFar) {
  Group group(25);
  group.add(testOptions(1));
  group.add(testOptions(2));
  ASSERT_TRUE(group.runUntil([&] { return group.allActive(); }, 10));
  // Every second tick of peer 2 is lost; it catches up by doing more steps in the others.
  TestPeer& slow = *group.peers()[1];
  for (int i = 0; i < 1200; ++i) {
    slow.isStalled = i % 2 == 1;
    group.tick();
    ASSERT_LE(std::abs(group.peers()[0]->world.step - slow.world.step), 32);
  }
  EXPECT_GT(group.peers()[0]->world.step, 1000);
}

TEST(Session, EveryMessageFitsOneFrameAndStatisticsAreSent) {
  Group group(200);
  for (int id = 1; id <= 2; ++id) group.add(testOptions(id));
  MemoryTransport listener(group.sharedNetwork());
  group.run(15);
  std::map<std::string, int> messages;
  listener.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
    EXPECT_LE(bytes.size(), kMaxMessageBytes);
    EXPECT_TRUE(std::holds_alternative<Message>(decode(channel, bytes, {.balls = 200})));
    ++messages[std::string(channel)];
  });
  EXPECT_NEAR(messages["WELLS_HEARTBEAT"], 2 * 15 * 10, 20);
  EXPECT_NEAR(messages["WELLS_CONFIG"], 2 * 15, 3);
  EXPECT_NEAR(messages["WELLS_STATISTICS"], 2 * 11, 6);
  EXPECT_GT(messages["WELLS_WELL"], 0);
  EXPECT_GT(messages["WELLS_OFFERS"], 0);
  EXPECT_GT(messages["WELLS_BALLS"], 0);
}

TEST(Session, RefusesOptionsOutsideTheirRanges) {
  World world = testWorld(3);
  MemoryTransport transport(std::make_shared<MemoryNetwork>());
  const auto refuses = [&](const std::function<void(SessionOptions&)>& damage) {
    SessionOptions options = testOptions(1);
    damage(options);
    EXPECT_THROW(Session(options, world, transport), std::invalid_argument);
  };
  refuses([](auto& o) { o.peer = kNobody; });
  refuses([](auto& o) { o.peer = PeerId{256}; });
  refuses([](auto& o) { o.lease = 0; });
  refuses([](auto& o) { o.lease = 61; });
  refuses([](auto& o) { o.stateRate = 0; });
  refuses([](auto& o) { o.ballsPerTick = 11; });
  refuses([](auto& o) { o.canonicalConfig.assign(1001, 'x'); });
  refuses([](auto& o) { o.well.at = nullptr; });
  refuses([](auto& o) { o.predict = nullptr; });
}

}  // namespace
}  // namespace wells
