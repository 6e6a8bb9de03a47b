// What a stranger may try who knows the format, the session and its members.
#include <gtest/gtest.h>

#include "network/codec_messages.h"
#include "network/session_recorder.h"

namespace wells {
namespace {

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

}  // namespace
}  // namespace wells
