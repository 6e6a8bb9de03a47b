// The parts of the session that stand alone.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "math/random.h"
#include "network/pace.h"
#include "network/peers.h"
#include "network/sequence_window.h"
#include "network/state_schedule.h"
#include "network/view_history.h"
#include "network/wells_exchange.h"
#include "network/world_difference.h"

namespace wells {
namespace {

// Against a plain set of all that was seen.
TEST(SequenceWindow, AcceptsEachNumberOnceInAnyOrder) {
  Random random(1);
  SequenceWindow window;
  std::set<std::int64_t> seen;
  std::int64_t highest = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t low = std::max<std::int64_t>(1, highest - 3000);
    const std::int64_t sequence = low + static_cast<std::int64_t>(random.below(3010));
    const bool isTooOld = sequence <= highest - SequenceWindow::kSize;
    EXPECT_EQ(window.accept(sequence), !isTooOld && seen.insert(sequence).second) << sequence;
    highest = std::max(highest, sequence);
    ASSERT_EQ(window.highest(), highest);
  }
}

TEST(SequenceWindow, ALeapForgetsWhatLiesBehindIt) {
  SequenceWindow window;
  EXPECT_TRUE(window.accept(1));
  EXPECT_TRUE(window.accept(1'000'000));
  EXPECT_FALSE(window.accept(1));
  EXPECT_TRUE(window.accept(999'999));
  EXPECT_FALSE(window.accept(1'000'000));
}

constexpr PaceRule kRule{.stepRate = 60, .slack = 3, .maxAhead = 30, .maxCatchUp = 4};

TEST(Pace, AloneOneStepATick) {
  EXPECT_EQ(stepsDue(100, 0, {}, kRule, 0), 1);
  EXPECT_FALSE(frontStep({}, kRule, 0));
}

TEST(Pace, CountsTheStepsThatAnotherHasProbablyDoneSinceItWasHeard) {
  const PeerPace peers[] = {{.step = 100, .heardAt = 5}, {.step = 90, .heardAt = 5}};
  EXPECT_EQ(frontStep(peers, kRule, 5), 100);
  EXPECT_EQ(frontStep(peers, kRule, 5.125), 107);
  EXPECT_EQ(frontStep(peers, kRule, 50), 115) << "but no more than a quarter of a second";
}

TEST(Pace, CatchesUpInPortionsAndIgnoresAFewSteps) {
  const PeerPace peers[] = {{.step = 100, .heardAt = 5}};
  EXPECT_EQ(stepsDue(97, 0, peers, kRule, 5), 1);
  EXPECT_EQ(stepsDue(96, 0, peers, kRule, 5), 4);
  EXPECT_EQ(stepsDue(0, 0, peers, kRule, 5), 4);
}

TEST(Pace, WaitsForTheSlowestThatIsHeardAndNotPaused) {
  const PeerPace slow[] = {{.step = 100, .heardAt = 5}};
  EXPECT_EQ(stepsDue(130, 0, slow, kRule, 5), 1);
  EXPECT_EQ(stepsDue(131, 0, slow, kRule, 5), 0);
  EXPECT_EQ(stepsDue(231, 0, slow, kRule, 5.51), 1) << "silent: it may be gone";
  const PeerPace paused[] = {{.step = 100, .heardAt = 5, .progress = Progress::Paused}};
  EXPECT_EQ(stepsDue(131, 0, paused, kRule, 5), 1);
}

World fallingBalls(std::size_t count) {
  World world;
  for (std::size_t i = 0; i < count; ++i)
    world.balls.add({.velocity = {0, -1 - static_cast<double>(i % 7), 0}}, 0.5, 1);
  world.roles.assign(count, Role::Owned);
  return world;
}

TEST(StateSchedule, SendsEverythingWhenItFitsAtTheRateOfItsMotion) {
  World world = fallingBalls(20);
  for (std::size_t i = 10; i < 20; ++i) world.balls.velocity[i] = Vec3::Zero();
  world.roles[0] = Role::Ghost;
  StateSchedule schedule(20);
  EXPECT_EQ(schedule.pick(world, {}, 0).size(), 19u) << "a ghost is not ours to send";
  EXPECT_EQ(schedule.pick(world, {}, 0.01).size(), 0u);
  EXPECT_EQ(schedule.pick(world, {}, 0.04).size(), 9u) << "the moving ones";
  EXPECT_EQ(schedule.pick(world, {}, 1.01).size(), 19u) << "those at rest once a second";
}

TEST(StateSchedule, ABallThatWasHitOrIsNewComesFirst) {
  World world = fallingBalls(1000);
  world.roles[3] = Role::Ghost;
  StateSchedule schedule(1000);
  const StatePace pace{.limit = 100};
  double now = 0;
  for (int i = 0; i < 30; ++i, now += 0.05) {
    schedule.observe(world);
    schedule.pick(world, pace, now);
  }
  const std::uint32_t hit = 500;
  world.balls.velocity[hit] += Vec3{1, 0, 0};
  world.roles[3] = Role::Owned;
  schedule.observe(world);
  const auto sent = schedule.pick(world, pace, now);
  EXPECT_EQ(sent.size(), 100u);
  EXPECT_TRUE(std::ranges::binary_search(sent, hit));
  EXPECT_TRUE(std::ranges::binary_search(sent, 3u));
}

TEST(StateSchedule, SmoothFallIsNoHit) {
  World world = fallingBalls(200);
  StateSchedule schedule(200);
  for (int i = 0; i < 5; ++i) {
    schedule.observe(world);
    for (Vec3& v : world.balls.velocity) v.y() -= 9.81 / 60;
  }
  schedule.pick(world, {.limit = 200}, 0);
  schedule.observe(world);
  EXPECT_EQ(schedule.pick(world, {.limit = 200}, 0.001).size(), 0u);
}

TEST(StateSchedule, NobodyStarvesHoweverManyAreHit) {
  constexpr std::size_t kBalls = 1000;
  World world = fallingBalls(kBalls);
  StateSchedule schedule(kBalls);
  std::vector<double> lastSent(kBalls, 0);
  double worst = 0;
  for (int tick = 0; tick < 600; ++tick) {
    const double now = tick / 30.0;
    for (std::size_t i = 0; i < 900; ++i)  // all the time
      world.balls.velocity[i].x() = tick % 2 ? 1 : -1;
    schedule.observe(world);
    const auto sent = schedule.pick(world, {.limit = 100}, now);
    EXPECT_LE(sent.size(), 100u);
    for (const std::uint32_t i : sent) {
      worst = std::max(worst, now - lastSent[i]);
      lastSent[i] = now;
    }
  }
  for (const double sent : lastSent) worst = std::max(worst, 20 - sent);
  // 900 share 75 places of a tick, 100 share 25.
  EXPECT_LT(worst, 0.5);
}

TEST(ViewHistory, KnowsWhatWasShownAtTheLast64Steps) {
  ViewHistory views;
  for (std::int64_t step = 0; step < 100; ++step)
    views.record(step, {Vec3{static_cast<double>(step), 0, 0}});
  EXPECT_FALSE(views.at(35, 0));
  EXPECT_EQ(views.at(36, 0)->x(), 36);
  EXPECT_EQ(views.at(99, 0)->x(), 99);
  EXPECT_FALSE(views.at(100, 0));
  views.clear();
  EXPECT_FALSE(views.at(99, 0));
}

TEST(ViewDifference, RemembersTheLargestAndThatOfTheLastSecond) {
  ViewDifference difference;
  EXPECT_EQ(difference.recent(7), 0);
  difference.add(3, 10);
  difference.add(1, 10.5);
  EXPECT_EQ(difference.recent(10.9), 3);
  EXPECT_EQ(difference.recent(11.2), 1);
  EXPECT_EQ(difference.recent(11.7), 0);
  EXPECT_EQ(difference.largest(), 3);
}

OwnWell lineWell() {
  return {.softening = 2, .at = [](PeerId, std::int64_t step) {
            return WellKeyframe{step, Vec3{static_cast<double>(step), 0, 0}, 40};
          }};
}

TEST(WellsExchange, OthersSeeTheWellThatItsOwnerSees) {
  const PeerId owner{4};
  Tracks own{{.keyframes = {{0, Vec3::Zero(), 1}}, .softening = 1, .peer = kNobody}};
  Tracks other = own;
  addOwnTrack(own, owner, lineWell(), 100, Appearance::Delayed);
  for (std::int64_t step = 100; step < 400; ++step) {
    extendOwnTrack(own, owner, lineWell(), step);
    pruneTracks(own, step);
    if (step % 7 != 0) continue;  // all other messages are lost
    learnTrack(other, wellMessage(own, owner), 0);
    pruneTracks(other, step);
    for (std::int64_t at = std::max<std::int64_t>(step - 100, 100); at <= step + 12; ++at) {
      EXPECT_EQ(wellAt(own[1], at, 1).position, wellAt(other[1], at, 1).position) << at;
      EXPECT_EQ(wellAt(own[1], at, 1).strength, wellAt(other[1], at, 1).strength) << at;
    }
  }
  EXPECT_GE(own[1].keyframes.back().step, 399 + kInputDelay);
  EXPECT_LE(own[1].keyframes.back().step, 399 + kInputDelay + kKeyframeInterval);
}

TEST(WellsExchange, ANewWellActsOnlyAfterTheInputDelay) {
  Tracks tracks;
  addOwnTrack(tracks, PeerId{1}, lineWell(), 100, Appearance::Delayed);
  EXPECT_EQ(wellAt(tracks[0], 100, 1).strength, 0);
  EXPECT_EQ(wellAt(tracks[0], 107, 1).strength, 0);
  EXPECT_EQ(wellAt(tracks[0], 112, 1).strength, 40);
  tracks.clear();
  addOwnTrack(tracks, PeerId{1}, lineWell(), 0, Appearance::AtOnce);
  EXPECT_EQ(wellAt(tracks[0], 0, 1).strength, 40);
}

TEST(WellsExchange, TracksAreInOneOrderWhoeverCameFirst) {
  Tracks tracks{{.keyframes = {{0, Vec3::Zero(), 1}}, .softening = 1, .peer = kNobody}};
  for (const int id : {3, 1, 2}) addOwnTrack(tracks, PeerId{id}, lineWell(), 0, Appearance::AtOnce);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(value(tracks[static_cast<std::size_t>(i)].peer), i);
  removeTracks(tracks, [](const WellTrack& track) { return track.peer != PeerId{2}; });
  ASSERT_EQ(tracks.size(), 2u) << "the fixed one stays";
  EXPECT_EQ(tracks[1].peer, PeerId{2});
}

TEST(WellsExchange, AWellIsSwitchedOffBetweenItsOwnersKeyframesAndOnAgainByThem) {
  Tracks own;
  addOwnTrack(own, PeerId{1}, lineWell(), 0, Appearance::AtOnce);
  Tracks other;
  learnTrack(other, wellMessage(own, PeerId{1}), 0);
  switchOff(other, PeerId{1}, 100);
  const std::int64_t off = other[0].keyframes.back().step;
  EXPECT_GE(off, 100 + kInputDelay);
  EXPECT_EQ(off % kKeyframeInterval, kKeyframeInterval / 2);
  EXPECT_NE(wellAt(other[0], off - 1, 1).strength, 0);
  EXPECT_EQ(wellAt(other[0], off, 1).strength, 0);

  // It was heard again: both learn what the other has, and their tracks are the same.
  for (std::int64_t step = 1; step <= 200; ++step) extendOwnTrack(own, PeerId{1}, lineWell(), step);
  EXPECT_EQ(learnTrack(own, wellMessage(other, PeerId{1}), 200), TrackNews::Late);
  learnTrack(other, wellMessage(own, PeerId{1}), 200);
  for (std::int64_t step = 120; step <= 212; ++step)
    EXPECT_EQ(wellAt(own[0], step, 1).strength, wellAt(other[0], step, 1).strength) << step;
  EXPECT_NE(wellAt(other[0], off + kKeyframeInterval, 1).strength, 0);
}

TEST(WellsExchange, SwitchingOffAnUnknownWellMakesNone) {
  Tracks tracks;
  switchOff(tracks, PeerId{1}, 100);
  EXPECT_TRUE(tracks.empty());
}

TEST(WellsExchange, AKeyframeOnceHeardIsNeverChanged) {
  Tracks tracks;
  addOwnTrack(tracks, PeerId{1}, lineWell(), 0, Appearance::AtOnce);
  Tracks other;
  gravity_wells::wells_t message = wellMessage(tracks, PeerId{1});
  learnTrack(other, message, 0);
  message.keyframes[1].position[0] = 1e6;
  learnTrack(other, message, 0);
  EXPECT_EQ(other[0].keyframes[1].position.x(), tracks[0].keyframes[1].position.x());
}

TEST(WorldDifference, NamesTheKeyAndBothValues) {
  EXPECT_EQ(describeDifference("A=1\nB=2\n", "A=1\nB=3\n"), "B is 2 there and 3 here");
  EXPECT_EQ(describeDifference("A=1\n", "A=1\nB=3"), "B is not set there and 3 here");
  EXPECT_EQ(describeDifference("A=1\nC=4", "A=1\n"), "C is 4 there and not set here");
  const DefaultValue five = [](std::string_view) { return "5"; };
  EXPECT_EQ(describeDifference("A=1\n", "", five), "A is 1 there and 5 (the default) here");
  EXPECT_EQ(describeDifference("A=x=y", "A=x=z"), "A is x=y there and x=z here");
  EXPECT_NE(describeDifference("A=1", "A=1").find("content of a file"), std::string::npos);
  describeDifference("\n\n===\n no key", "");  // foreign text may be anything
}

// The table of peers, by hand-made heartbeats.
class PeersTest : public testing::Test {
 protected:
  gravity_wells::heartbeat_t heartbeat(int id, std::int64_t incarnation, std::int64_t startedS) {
    gravity_wells::heartbeat_t m;
    m.header = {.utime = 1'000'000'000,
                .protocol = 1,
                .peer_id = id,
                .incarnation = incarnation,
                .sequence = ++sequence_,
                .generation_resets = 0,
                .generation_founded = 500,
                .generation_nonce = 5,
                .step = ++step_};
    m.started = startedS * 1'000'000;
    m.world_hash = 42;
    m.phase = gravity_wells::heartbeat_t::ACTIVE;
    m.paused = 0;
    m.complete = 0;
    m.lease_ms = 2000;
    m.balls_owned = 0;
    return m;
  }
  static Times at(double t) { return {t, 1'000'000'000 + static_cast<std::int64_t>(t * 1e6)}; }
  PeersTest() { peers_.setGeneration({0, 500, 5}); }

  std::int64_t sequence_ = 0, step_ = 0;
  Peers peers_{42, 30};
};

TEST_F(PeersTest, AHeartbeatIntroducesAndOnlyAHeartbeatDoes) {
  const auto m = heartbeat(1, 11, 1);
  EXPECT_EQ(peers_.hear(m.header, at(0)), Drop::UnknownSender);
  EXPECT_FALSE(peers_.hear(m, at(0)));
  EXPECT_EQ(peers_.hear(m, at(0)), Drop::Replayed);
  EXPECT_EQ(peers_.livingActive(0).size(), 1u);
  EXPECT_EQ(peers_.livingActive(2).size(), 0u);
}

TEST_F(PeersTest, APhaseThatWasOvertakenIsNotHeeded) {
  const auto first = heartbeat(1, 11, 1);
  auto later = heartbeat(1, 11, 1);
  later.phase = gravity_wells::heartbeat_t::SYNCING;
  EXPECT_FALSE(peers_.hear(later, at(0)));
  EXPECT_FALSE(peers_.hear(first, at(0)));
  EXPECT_EQ(peers_.find(11)->phase, Phase::Syncing);
}

TEST_F(PeersTest, AHeartbeatThatOtherMessagesOvertookStillRenewsTheLease) {
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0)));
  for (int i = 1; i <= 10; ++i) {
    auto paused = heartbeat(1, 11, 1);
    paused.paused = 1;
    const auto states = heartbeat(1, 11, 1).header;  // sent after it, in the same burst
    EXPECT_FALSE(peers_.hear(states, at(i)));
    EXPECT_FALSE(peers_.hear(paused, at(i)));
    ASSERT_EQ(peers_.livingActive(i).size(), 1u) << "it stands still on purpose";
  }
}

TEST_F(PeersTest, OneThatComesBackAsANewIncarnationReplacesTheOldOne) {
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0)));
  EXPECT_FALSE(peers_.hear(heartbeat(1, 12, 2), at(1.1)));
  ASSERT_EQ(peers_.livingActive(1.1).size(), 1u) << "the old one was silent for half a lease";
  EXPECT_EQ(peers_.livingActive(1.1)[0]->who.number, 12);
  EXPECT_EQ(peers_.hear(heartbeat(1, 11, 1), at(2)), Drop::DeadSender);
  EXPECT_EQ(peers_.hear(heartbeat(1, 11, 1).header, at(2)), Drop::DeadSender);
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(4))) << "the newer one is gone";
  EXPECT_EQ(peers_.livingActive(4)[0]->who.number, 11);
}

TEST_F(PeersTest, OfTwoThatAreHeardWithOneIdBothLive) {
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0)));
  EXPECT_FALSE(peers_.hear(heartbeat(1, 12, 2), at(0.5)));
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0.9)));
  EXPECT_FALSE(peers_.hear(heartbeat(1, 12, 2), at(1.4)));
  EXPECT_EQ(peers_.livingActive(1.5).size(), 2u) << "nobody's balls may be adopted for that";
}

TEST_F(PeersTest, AJoinerReplacesNobody) {
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0)));
  auto joiner = heartbeat(1, 12, 2);
  joiner.phase = gravity_wells::heartbeat_t::JOINING;
  joiner.header.generation_founded = joiner.header.generation_nonce = 0;
  EXPECT_FALSE(peers_.hear(joiner, at(0)));
  EXPECT_EQ(peers_.livingActive(0)[0]->who.number, 11);
  EXPECT_EQ(peers_.audible(0).size(), 2u);
}

TEST_F(PeersTest, AGoodByeIsForGood) {
  EXPECT_FALSE(peers_.hear(heartbeat(1, 11, 1), at(0)));
  auto bye = heartbeat(1, 11, 1);
  bye.phase = gravity_wells::heartbeat_t::LEAVING;
  EXPECT_FALSE(peers_.hear(bye, at(1)));
  EXPECT_TRUE(peers_.living(1).empty());
  EXPECT_EQ(peers_.hear(heartbeat(1, 11, 1), at(1)), Drop::DeadSender);
}

TEST_F(PeersTest, IncarnationsThatAreInventedDoNotFillTheMemory) {
  int refused = 0;
  for (int i = 0; i < 5000; ++i)
    if (peers_.hear(heartbeat(1 + i % 255, 1000 + i, i), at(0)) == Drop::UnknownSender) ++refused;
  EXPECT_EQ(refused, 5000 - 2048);
  peers_.forget(100);
  EXPECT_EQ(peers_.find(1000), nullptr);
}

TEST_F(PeersTest, OtherWorldsAndClocksAreRefused) {
  auto foreign = heartbeat(1, 11, 1);
  foreign.world_hash = 43;
  EXPECT_EQ(peers_.hear(foreign, at(0)), Drop::ForeignWorld);
  EXPECT_EQ(peers_.hear(heartbeat(1, 11, 1).header, at(0)), Drop::ForeignWorld);
  EXPECT_NE(peers_.foreignSenior(5'000'000, 1, 0), nullptr);
  auto off = heartbeat(2, 22, 1);
  off.header.utime += 31'000'000;
  EXPECT_EQ(peers_.hear(off, at(0)), Drop::ClockApart);
  off.header.utime -= 62'000'000;
  EXPECT_EQ(peers_.hear(off, at(0)), Drop::ClockApart);
  EXPECT_EQ(peers_.lowestFreeId(0), PeerId{1}) << "who simulates another world takes no id";
}

}  // namespace
}  // namespace wells
