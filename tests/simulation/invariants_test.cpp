// Each promise's check, on views made by hand: it says nothing of what is right and finds what is
// wrong.
#include "simulation/invariants.h"

#include <gtest/gtest.h>

#include <limits>

namespace wells::simulation {
namespace {

constexpr double kLease = 2;
constexpr Generation kGeneration{.resets = 0, .foundedUs = 100, .nonce = 7};
constexpr Incarnation kOne{PeerId{1}, 11}, kTwo{PeerId{2}, 22}, kThree{PeerId{3}, 33};
constexpr std::size_t kBalls = 2;

bool nobody(const Incarnation&) {
  return false;
}
bool everybody(const Incarnation&) {
  return true;
}

/// What a peer knows; its view refers to it.
struct Knowledge {
  Knowledge(int number, const Incarnation& who) : process(number), self(who) {
    for (std::size_t i = 0; i < kBalls; ++i) balls.add({.position = {1, 2, 3}}, 0.5, 1);
  }
  void know(std::size_t ball, const Incarnation& owner, std::int64_t epoch,
            Standing standing = Standing::Heard) {
    records[ball] = {{.generation = kGeneration, .epoch = epoch, .owner = owner, .step = 10},
                     standing};
    roles[ball] = owns(records[ball], self) ? Role::Owned : Role::Ghost;
  }
  PeerView view() const {
    return {.process = process,
            .self = self,
            .phase = Phase::Active,
            .generation = kGeneration,
            .step = 10,
            .records = records,
            .roles = roles,
            .balls = &balls,
            .tracks = &tracks};
  }
  int process;
  Incarnation self;
  std::vector<Record> records = std::vector<Record>(kBalls);
  std::vector<Role> roles = std::vector<Role>(kBalls, Role::Ghost);
  Balls balls;
  std::vector<WellTrack> tracks;
};

/// One and two know that one owns both balls.
struct InvariantsTest : testing::Test {
  InvariantsTest() {
    for (const Knowledge* peer : {&one, &two}) {
      PeerView listening = peer->view();
      listening.phase = Phase::Joining;
      listening.generation = {};
      invariants.observe(listening, now - 2 * kLease, nobody);
    }
    for (Knowledge* peer : {&one, &two})
      for (std::size_t i = 0; i < kBalls; ++i) peer->know(i, kOne, 0);
    observe();
  }
  void observe(const std::function<bool(const Incarnation&)>& wasHeard = nobody) {
    invariants.observe(one.view(), now, wasHeard);
    invariants.observe(two.view(), now, wasHeard);
  }
  void checkGroup() { invariants.group(std::vector{one.view(), two.view()}, now); }
  void expectOnly(Invariant invariant) {
    ASSERT_EQ(invariants.violations().size(), 1u);
    EXPECT_EQ(invariants.violations().front().invariant, invariant)
        << invariants.violations().front().what;
  }
  void expectNone() {
    for (const Violation& violation : invariants.violations()) ADD_FAILURE() << violation.what;
  }
  Invariants invariants{kBalls, kLease};
  Knowledge one{0, kOne}, two{1, kTwo};
  double now = 10;
};

TEST_F(InvariantsTest, AHandOverBreaksNone) {
  checkGroup();
  one.know(0, kTwo, 1, Standing::Named);
  observe();
  checkGroup();
  two.know(0, kTwo, 1);
  observe();
  checkGroup();
  one.know(0, kTwo, 1);
  observe();
  checkGroup();
  invariants.healed(std::vector{one.view(), two.view()}, now);
  invariants.complete(std::vector{one.view(), two.view()}, now);
  expectNone();
}

TEST_F(InvariantsTest, ATenureHasOneOwnerEver) {
  invariants.claim(1, {.generation = kGeneration, .epoch = 3, .owner = kTwo, .step = 10}, now);
  invariants.claim(1, {.generation = kGeneration, .epoch = 3, .owner = kTwo, .step = 12}, now);
  invariants.claim(0, {.generation = kGeneration, .epoch = 3, .owner = kThree, .step = 10}, now);
  expectNone();
  invariants.claim(1, {.generation = kGeneration, .epoch = 3, .owner = kThree, .step = 12}, now);
  expectOnly(Invariant::OneOwnerEver);
}

TEST_F(InvariantsTest, ATenureThatTwoPeersKnowDifferentlyIsFoundInTheirRecords) {
  one.know(0, kTwo, 1, Standing::Named);
  two.know(0, kThree, 1, Standing::Named);
  observe();
  expectOnly(Invariant::OneOwnerEver);
}

TEST_F(InvariantsTest, VersionsRise) {
  one.know(1, kTwo, 5, Standing::Named);
  observe();
  one.know(1, kTwo, 4, Standing::Named);
  observe();
  expectOnly(Invariant::VersionsRise);
}

TEST_F(InvariantsTest, AVersionMayFallInAnotherIncarnation) {
  one.know(1, kTwo, 5, Standing::Named);
  observe();
  one.self = {PeerId{1}, 12};
  for (std::size_t i = 0; i < kBalls; ++i) one.know(i, kTwo, 4, Standing::Named);
  observe();
  expectNone();
}

TEST_F(InvariantsTest, WhatIsNotANumberIsFound) {
  two.balls.velocity[1].z() = std::numeric_limits<double>::quiet_NaN();
  observe();
  expectOnly(Invariant::Complete);
}

TEST_F(InvariantsTest, AMissingRecordIsFound) {
  two.records.pop_back();
  observe();
  expectOnly(Invariant::Complete);
}

TEST_F(InvariantsTest, RolesAndRecordsMatch) {
  two.roles[0] = Role::Owned;
  observe();
  expectOnly(Invariant::RolesMatch);
}

TEST_F(InvariantsTest, TwoOwnersInAGroupAreFound) {
  two.records[0].version.term = 1;
  two.records[0].version.adopter = two.records[0].version.owner = kTwo;
  checkGroup();
  expectOnly(Invariant::OneActsAsOwner);
}

TEST_F(InvariantsTest, ABallWhoseOwnerIsNotOfTheGroupIsFound) {
  for (Knowledge* peer : {&one, &two}) peer->know(1, kThree, 1);
  checkGroup();
  expectOnly(Invariant::OneActsAsOwner);
}

TEST_F(InvariantsTest, WhoIsNamedMustTakeTheBallWithinTwoLeases) {
  for (Knowledge* peer : {&one, &two}) peer->know(1, kTwo, 1, Standing::Named);
  for (; now < 10 + 2 * kLease; now += 0.125) checkGroup();
  expectNone();
  now += 0.125;
  checkGroup();
  expectOnly(Invariant::NobodyForLong);
}

TEST_F(InvariantsTest, ABallThatIsTakenNowAndThenIsNotWithoutOwnerForLong) {
  for (int epoch = 1; epoch < 20; ++epoch, now += 0.5) {
    for (Knowledge* peer : {&one, &two}) peer->know(1, kTwo, epoch, Standing::Named);
    checkGroup();
    two.know(1, kTwo, epoch);
    checkGroup();
  }
  expectNone();
}

TEST_F(InvariantsTest, NobodyAdoptsFromTheLiving) {
  two.records[1] = {{.generation = kGeneration, .term = 1, .adopter = kTwo, .owner = kTwo},
                    Standing::Heard};
  two.roles[1] = Role::Owned;
  observe(everybody);
  expectOnly(Invariant::LivingKeepTheirs);
}

TEST_F(InvariantsTest, AdoptionFromWhoWasSilentIsRight) {
  // The adopter learns of a later owner, who was silent, in the same moment.
  invariants.claim(1, {.generation = kGeneration, .epoch = 1, .owner = kThree, .step = 9}, now);
  two.records[1] = {{.generation = kGeneration, .term = 1, .adopter = kTwo, .owner = kTwo},
                    Standing::Heard};
  two.roles[1] = Role::Owned;
  observe([](const Incarnation& who) { return who == kOne; });
  expectNone();
}

TEST_F(InvariantsTest, AJoinerKnowsWhatHasBeenKnownForASecond) {
  Knowledge joiner{2, kThree};
  for (std::size_t i = 0; i < kBalls; ++i) joiner.know(i, kOne, 0);
  for (const PeerId id : {kOne.peer, kTwo.peer})
    joiner.tracks.push_back({.keyframes = {WellKeyframe{}}, .peer = id});
  one.know(1, kTwo, 1, Standing::Named);
  observe();
  now += 0.5;
  invariants.joined(joiner.view(), std::vector{0, 1}, now);
  expectNone();
  now += 1;
  invariants.joined(joiner.view(), std::vector{1}, now);
  expectNone();
  invariants.joined(joiner.view(), std::vector{0, 1}, now);
  expectOnly(Invariant::JoinersKnow);
}

TEST_F(InvariantsTest, TwoGenerationsAfterHealingAreFound) {
  PeerView other = two.view();
  other.generation.nonce = 8;
  invariants.healed(std::vector{one.view(), other}, now);
  expectOnly(Invariant::Heals);
}

TEST_F(InvariantsTest, TwoOwnersAfterHealingAreFound) {
  two.know(0, kTwo, 1);
  invariants.healed(std::vector{one.view(), two.view()}, now);
  expectOnly(Invariant::Heals);
}

TEST_F(InvariantsTest, ADifferenceOfOneBitInTheEndIsFound) {
  two.balls.position[1].x() += 0x1p-52;
  invariants.complete(std::vector{one.view(), two.view()}, now);
  expectOnly(Invariant::Agree);
}

TEST_F(InvariantsTest, ADifferentRecordInTheEndIsFound) {
  two.know(1, kOne, 1);
  invariants.complete(std::vector{one.view(), two.view()}, now);
  expectOnly(Invariant::Agree);
}

TEST_F(InvariantsTest, DifferentSettingsInTheEndAreFound) {
  PeerView other = two.view();
  other.settings = 1;
  invariants.complete(std::vector{one.view(), other}, now);
  expectOnly(Invariant::Agree);
}

}  // namespace
}  // namespace wells::simulation
