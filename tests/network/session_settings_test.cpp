// What all peers of a session share: settings, pause, resets, and the wells of those who are gone.
#include <gtest/gtest.h>

#include <algorithm>

#include "session_group.h"

namespace wells {
namespace {

/// A program that is no peer and asks for settings to be changed.
class Operator {
 public:
  explicit Operator(Group& group)
      : group_(group), transport_(group.sharedNetwork()), setter_(++lastSetter_) {}

  void set(const std::string& key, const std::string& value, std::int64_t fromStep,
           std::int64_t version = 1) {
    TestPeer& peer = *group_.peers().front();
    const Generation generation = peer.session->generation();
    gravity_wells::request_t m;
    m.header = {.utime = group_.timesOf(peer).wallUs,
                .protocol = gravity_wells::peer_header_t::PROTOCOL,
                .peer_id = 0,
                .incarnation = setter_,
                .sequence = 1,
                .generation_resets = generation.resets,
                .generation_founded = generation.foundedUs,
                .generation_nonce = generation.nonce,
                .step = 0};
    m.count = 1;
    m.settings = {{key, value, version, setter_, "operator", fromStep}};
    MessageBuffer buffer;
    transport_.publish("WELLS_REQUEST", encode(m, buffer));
  }

 private:
  static inline std::int64_t lastSetter_ = 0;
  Group& group_;
  MemoryTransport transport_;
  std::int64_t setter_;
};

class SessionSettings : public ::testing::Test {
 protected:
  void start(int peers) {
    for (int id = 1; id <= peers; ++id) group_.add(testOptions(id));
    ASSERT_TRUE(group_.runUntil([&] { return group_.allActiveInOneGeneration(); }, 15));
    group_.run(1);
  }
  std::int64_t furthest() {
    std::int64_t step = 0;
    for (const auto& peer : group_.peers()) step = std::max(step, peer->world.step);
    return step;
  }

  Group group_{30};
};

TEST_F(SessionSettings, HoldFromTheSameStepForAll) {
  start(3);
  const std::int64_t from = furthest() + 30;
  Operator(group_).set("Gravity", "reversed", from);
  for (int tick = 0; tick < 120; ++tick) {
    group_.tick();
    for (const auto& peer : group_.peers())
      EXPECT_EQ(peer->world.settings.gravity.y(), peer->world.step >= from ? 9.81 : -9.81)
          << peer->world.step;
  }
}

TEST_F(SessionSettings, AJoinerKnowsThemBeforeItTakesPart) {
  start(2);
  Operator(group_).set("Friction", "0.75", furthest());
  Operator(group_).set("Elasticity", "0.125", furthest());
  Operator(group_).set("RollingResistance", "0.0625", furthest());
  group_.run(1);
  TestPeer& late = group_.add(testOptions(3));
  ASSERT_TRUE(group_.runUntil([&] { return late.session->phase() == Phase::Active; }, 10));
  EXPECT_EQ(late.world.settings.friction, 0.75);
  EXPECT_EQ(late.world.settings.elasticity, 0.125);
  EXPECT_EQ(late.world.settings.rollingResistance, 0.0625);
}

TEST_F(SessionSettings, OfTwoAtOnceAllTakeTheSame) {
  start(3);
  Operator one(group_), two(group_);
  one.set("Friction", "0.1", furthest());
  two.set("Friction", "0.2", furthest());
  group_.run(1);
  for (const auto& peer : group_.peers()) EXPECT_EQ(peer->world.settings.friction, 0.2);
}

TEST_F(SessionSettings, HealAfterAPartition) {
  start(2);
  const int a = group_.peers()[0]->transport->endpoint();
  const int b = group_.peers()[1]->transport->endpoint();
  Operator inside(group_);  // it hears and is heard by both
  group_.network().setLink(a, b, MemoryLink::Cut);
  group_.network().setLink(b, a, MemoryLink::Cut);
  group_.network().setFaults({.loss = 0.5});
  inside.set("Friction", "0.9", furthest());  // reaches one, both or nobody
  group_.run(0.5);
  group_.network().setFaults({});
  inside.set("Friction", "0.9", furthest());
  group_.network().setLink(a, b, MemoryLink::Up);
  group_.network().setLink(b, a, MemoryLink::Up);
  group_.run(1);
  for (const auto& peer : group_.peers()) EXPECT_EQ(peer->world.settings.friction, 0.9);
}

TEST_F(SessionSettings, RefusedValuesChangeNothingAndAreCounted) {
  start(2);
  Operator(group_).set("Friction", "-1", furthest());
  Operator(group_).set("Colour", "red", furthest());
  Operator(group_).set("2.WellStrength", "1", furthest());  // this program knows no such key
  group_.run(1);
  for (const auto& peer : group_.peers()) {
    EXPECT_TRUE(peer->session->settings().registers().empty());
    EXPECT_EQ(peer->session->counts().drops[Drop::OutOfRange], 3);
  }
}

TEST_F(SessionSettings, AnApplicationObeysItsOwnKeys) {
  SessionOptions options = testOptions(1);
  options.checkSetting = [](std::string_view key, std::string_view) -> std::optional<std::string> {
    if (key == "1.WellStrength") return std::nullopt;
    return "no such setting";
  };
  TestPeer& peer = group_.add(options);
  ASSERT_TRUE(group_.runUntil([&] { return group_.allActive(); }, 15));
  Operator(group_).set("1.WellStrength", "-40", furthest() + 5);
  group_.run(1);
  const Register* set = peer.session->settings().inForce("1.WellStrength", peer.world.step);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->value, "-40");
}

TEST_F(SessionSettings, APauseStopsAllAtOneStepAndKeepsTheirLeases) {
  start(3);
  const std::int64_t from = furthest() + 10;
  Operator(group_).set("Pause", "true", from);
  group_.run(10);  // several leases
  for (const auto& peer : group_.peers()) {
    EXPECT_EQ(peer->world.step, from);
    EXPECT_EQ(peer->session->counts().balls.adoptions, 0);
    EXPECT_EQ(peer->session->livingPeers(group_.timesOf(*peer)).size(), 3u);
  }
  EXPECT_TRUE(group_.everyBallHasOneOwner());
  Operator(group_).set("Pause", "false", from, 2);
  group_.run(2);
  for (const auto& peer : group_.peers()) EXPECT_GE(peer->world.step, from + 60);
}

TEST_F(SessionSettings, WhoHearsOfAPauseLateIsCaughtUpWith) {
  start(3);
  const std::int64_t past = furthest() - 20;
  Operator(group_).set("Pause", "true", past);
  group_.run(3);
  for (const auto& peer : group_.peers()) EXPECT_EQ(peer->world.step, furthest());
}

TEST_F(SessionSettings, ThePaceIsShared) {
  start(2);
  Operator(group_).set("SimulationRate", "30", furthest());
  group_.run(0.5);
  for (const auto& peer : group_.peers()) EXPECT_EQ(peer->session->stepRate(peer->world), 30);
}

TEST_F(SessionSettings, AResetStartsTheWorldOverForAll) {
  start(3);
  group_.run(5);
  const Generation before = group_.peers()[0]->session->generation();
  Operator(group_).set("Friction", "0.6", furthest());
  Operator(group_).set("Reset", "1", furthest());
  group_.run(0.2);
  const TestPeer& lowest = *group_.peers()[0];
  EXPECT_LT(lowest.world.step, 60);
  ASSERT_TRUE(group_.runUntil([&] { return group_.allActiveInOneGeneration(); }, 10));
  for (const auto& peer : group_.peers()) {
    EXPECT_EQ(peer->session->generation().resets, before.resets + 1);
    EXPECT_LT(peer->world.step, 600);
    EXPECT_EQ(peer->world.settings.friction, 0.6) << "what was set stays set";
  }
  ASSERT_TRUE(group_.runUntil([&] { return group_.everyBallHasOneOwner(); }, 4));
  group_.run(3);
  ASSERT_TRUE(group_.settle(5));
  group_.expectEqualViews();
}

TEST_F(SessionSettings, TheWellOfOneWhoIsGoneIsSwitchedOffAtOneStepForAll) {
  start(4);
  group_.run(3);
  group_.kill(*group_.peers()[2]);
  std::map<std::int64_t, std::vector<double>> strengths;  // by step, of peer 3's well
  for (int tick = 0; tick < 400; ++tick) {
    group_.tick();
    for (const auto& peer : group_.peers()) {
      const auto track = std::ranges::find(peer->world.tracks, PeerId{3}, &WellTrack::peer);
      const bool isThere = track != peer->world.tracks.end();
      strengths[peer->world.step].push_back(
          isThere ? wellAt(*track, peer->world.step, kTick).strength : 0);
    }
  }
  EXPECT_NE(strengths.begin()->second.front(), 0);
  EXPECT_EQ(strengths.rbegin()->second.front(), 0);
  for (const auto& [step, seen] : strengths)
    for (const double strength : seen) EXPECT_EQ(strength, seen.front()) << "step " << step;
}

}  // namespace
}  // namespace wells
