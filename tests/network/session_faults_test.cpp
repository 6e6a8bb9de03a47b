// The session on bad networks, with peers that die, stall and come back, and with messages that
// nobody honest has sent.
#include <gtest/gtest.h>

#include <cstdlib>

#include "network/codec_messages.h"
#include "network/session_group.h"

namespace wells {
namespace {

constexpr MemoryFaults kBadNetwork{.loss = 0.2, .duplication = 0.2, .delay = 0.05, .jitter = 0.1};

/// Everything that is published, to be looked at and to be played back.
class Recorder {
 public:
  explicit Recorder(Group& group) : transport_(group.sharedNetwork()) {}

  void record() {
    transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
      messages_.emplace_back(channel, std::vector<std::byte>(bytes.begin(), bytes.end()));
    });
  }
  const auto& messages() const { return messages_; }
  void clear() { messages_.clear(); }
  void send(std::string_view channel, std::span<const std::byte> bytes) {
    transport_.publish(channel, bytes);
  }
  void send(const Message& message) {
    MessageBuffer buffer;
    const auto bytes = encode(message, buffer);
    send(std::visit([](const auto& m) { return channelOf(m); }, message), bytes);
  }

 private:
  MemoryTransport transport_;
  std::vector<std::pair<std::string, std::vector<std::byte>>> messages_;
};

struct Snapshot {
  std::vector<Record> records;
  std::vector<Vec3> positions;
  std::vector<Role> roles;
  bool operator==(const Snapshot&) const = default;
};

std::vector<Snapshot> snapshot(const Group& group) {
  std::vector<Snapshot> snapshots;
  for (const auto& peer : const_cast<Group&>(group).peers())
    snapshots.push_back({peer->session->records(), peer->world.balls.position, peer->world.roles});
  return snapshots;
}

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

// What a stranger may try who knows the format, the session and its members.
class Forger : public testing::Test {
 protected:
  Forger() {
    for (int id = 1; id <= 2; ++id) group_.add(testOptions(id));
    group_.run(8);
    EXPECT_TRUE(group_.settle(5));
    before_ = snapshot(group_);
  }

  Session& victim() { return *group_.peers()[0]->session; }

  gravity_wells::peer_header_t header(const Incarnation& who, const Generation& generation) {
    return {.utime = group_.timesOf(*group_.peers()[0]).wallUs,
            .protocol = gravity_wells::peer_header_t::PROTOCOL,
            .peer_id = value(who.peer),
            .incarnation = who.number,
            .sequence = ++sequence_,
            .generation_resets = generation.resets,
            .generation_founded = generation.foundedUs,
            .generation_nonce = generation.nonce,
            .step = group_.peers()[0]->world.step};
  }

  /// A state of ball 0 by `who`, better than what everybody has by so many terms and epochs.
  gravity_wells::ball_states_t state(const Incarnation& who, const Generation& generation,
                                     std::int64_t terms, std::int64_t epochs) {
    const Version& version = victim().records()[0].version;
    gravity_wells::ball_states_t m;
    m.header = header(who, generation);
    m.step = group_.peers()[0]->world.step;
    m.count = 1;
    m.balls = {goodBall(0)};
    m.balls[0].term = version.term + terms;
    m.balls[0].epoch = version.epoch + epochs;
    m.balls[0].adopter = value(version.adopter.peer);
    m.balls[0].adopter_incarnation = version.adopter.number;
    return m;
  }

  void expectRefused(const Message& message, Drop reason) {
    const std::int64_t count = victim().counts().drops[reason];
    recorder_.send(message);
    group_.tick();
    EXPECT_GT(victim().counts().drops[reason], count) << name(reason);
    EXPECT_EQ(snapshot(group_), before_) << name(reason);
  }

  Group group_{60};
  Recorder recorder_{group_};
  std::vector<Snapshot> before_;
  std::int64_t sequence_ = 1'000'000;
  const Incarnation stranger_{PeerId{9}, 1234567};
};

TEST_F(Forger, IsUnknownWithoutAHeartbeat) {
  expectRefused(state(stranger_, victim().generation(), 0, 1), Drop::UnknownSender);
}

TEST_F(Forger, CannotSpeakForAnotherPeer) {
  const Incarnation other = group_.peers()[1]->session->self();
  expectRefused(state({PeerId{9}, other.number}, victim().generation(), 0, 1), Drop::UnknownSender);
}

TEST_F(Forger, CannotSpeakForAnotherGeneration) {
  const Incarnation other = group_.peers()[1]->session->self();
  expectRefused(state(other, {0, 77, 7}, 0, 1), Drop::ForeignGeneration);
}

TEST_F(Forger, CannotTakeWhatSomebodyElseOwns) {
  // Ball 0 is owned by one of the two; the other claims its very tenure.
  const bool isFirst = group_.peers()[0]->world.roles[0] == Role::Owned;
  ASSERT_TRUE(isFirst || group_.peers()[1]->world.roles[0] == Role::Owned);
  const Incarnation claimant = group_.peers()[isFirst ? 1 : 0]->session->self();
  const Message claim = state(claimant, victim().generation(), 0, 0);
  if (isFirst) {
    expectRefused(claim, Drop::NotOwner);
  } else {
    expectRefused(claim, Drop::Echo);
  }
}

TEST_F(Forger, CannotClaimATermWithoutAnAdopter) {
  const Incarnation other = group_.peers()[1]->session->self();
  auto claim = state(other, victim().generation(), 1, 0);
  claim.balls[0].adopter = 0;
  claim.balls[0].adopter_incarnation = 0;
  expectRefused(claim, Drop::ImpossibleVersion);
}

TEST_F(Forger, CannotSendFromTheFarFuture) {
  const Incarnation other = group_.peers()[1]->session->self();
  auto claim = state(other, victim().generation(), 0, 1);
  claim.step += 10'000;
  expectRefused(claim, Drop::TooFarAhead);
}

TEST_F(Forger, HasNoSayBeforeItIsActive) {
  gravity_wells::heartbeat_t heartbeat = goodHeartbeat();
  heartbeat.header = header(stranger_, victim().generation());
  heartbeat.started = heartbeat.header.utime;
  heartbeat.world_hash = 42;
  heartbeat.phase = gravity_wells::heartbeat_t::SYNCING;
  recorder_.send(heartbeat);
  group_.tick();
  expectRefused(state(stranger_, victim().generation(), 0, 1), Drop::NotActive);
}

TEST_F(Forger, CannotMakeAPeerAcceptWhatIsOfferedToAnotherIncarnationOfIt) {
  const Version& version = victim().records()[0].version;
  gravity_wells::offers_t m;
  m.header = header(group_.peers()[1]->session->self(), victim().generation());
  m.receiver = value(victim().peer());
  m.receiver_incarnation = victim().self().number ^ 1;
  m.step = group_.peers()[0]->world.step;
  m.count = 1;
  m.balls = {goodBall(0)};
  m.balls[0].term = version.term;
  m.balls[0].epoch = version.epoch + 1;
  m.balls[0].adopter = value(version.adopter.peer);
  m.balls[0].adopter_incarnation = version.adopter.number;
  recorder_.send(m);
  group_.tick();
  EXPECT_EQ(group_.peers()[0]->world.roles[0], Role::Ghost);
  EXPECT_FALSE(owns(victim().records()[0], victim().self()));
  // That one does not exist, so somebody adopts the ball.
  EXPECT_TRUE(group_.runUntil([&] { return group_.everyBallHasOneOwner(); }, 2 * kLease));
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
