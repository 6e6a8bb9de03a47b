#include "simulation/contacts.h"

#include <gtest/gtest.h>

namespace wells::simulation {
namespace {

constexpr double kLease = 2;
constexpr Generation kGeneration{.resets = 0, .foundedUs = 100, .nonce = 7};
constexpr Incarnation kOther{PeerId{2}, 22};

/// An active peer's heartbeats, each with another step.
struct ContactsTest : testing::Test {
  void beat(double now) {
    gravity_wells::heartbeat_t heartbeat{};
    heartbeat.header.peer_id = value(kOther.peer);
    heartbeat.header.incarnation = kOther.number;
    heartbeat.header.sequence = ++sequence;
    heartbeat.header.generation_founded = kGeneration.foundedUs;
    heartbeat.header.generation_nonce = kGeneration.nonce;
    heartbeat.header.step = step;
    heartbeat.phase = gravity_wells::heartbeat_t::ACTIVE;
    contacts.hear(heartbeat, kGeneration, now);
  }
  Contacts contacts{kLease};
  std::int64_t sequence = 0;
  std::int64_t step = 0;
};

TEST_F(ContactsTest, IsSteadyWhileNoGapIsLong) {
  for (; step < 50; ++step) beat(0.1 * static_cast<double>(step));
  EXPECT_TRUE(contacts.isSteady(kOther, 4, 5));
  EXPECT_FALSE(contacts.isSteady(kOther, 5.5, 5)) << "heard for 5 s only";
  EXPECT_FALSE(contacts.isSteady(kOther, 1, 6.6)) << "silent for 1.7 s";
  beat(6.6);
  EXPECT_FALSE(contacts.isSteady(kOther, 1, 7)) << "began again at 6.6 s";
  EXPECT_FALSE(contacts.isSteady({PeerId{2}, 23}, 0, 5)) << "another incarnation";
}

TEST_F(ContactsTest, IsCloseWhileNoGapIsAQuarterOfALease) {
  for (; step < 50; ++step) beat(0.1 * static_cast<double>(step));
  EXPECT_TRUE(contacts.isClose(kOther, 4, 5));
  EXPECT_FALSE(contacts.isClose(kOther, 4, 5.6));
  beat(5.6);
  EXPECT_FALSE(contacts.isClose(kOther, 1, 5.7)) << "began again at 5.6 s";
  EXPECT_TRUE(contacts.isSteady(kOther, 4, 5.7));
}

TEST_F(ContactsTest, HearsOnlyThoseWhoAreNotSilent) {
  beat(0);
  EXPECT_FALSE(contacts.hearsOnly({}, 4, 1));
  EXPECT_TRUE(contacts.hearsOnly({kOther}, 4, 1));
  EXPECT_TRUE(contacts.hearsOnly({}, 4, 4.5));
}

TEST_F(ContactsTest, AMessageThatIsPlayedBackSaysNothing) {
  beat(0);
  sequence = 0;
  beat(5);
  EXPECT_TRUE(contacts.hearsOnly({}, 4, 5));
}

TEST_F(ContactsTest, AnOldMessageThatWasNotHeardThenIsNoSignOfLife) {
  for (step = 10; step < 30; ++step) {
    if (step == 20) ++sequence;  // lost
    beat(0.1 * static_cast<double>(step));
  }
  const std::int64_t newest = sequence;
  sequence = 10;
  beat(4);
  EXPECT_FALSE(contacts.isSteady(kOther, 0.5, 4.5)) << "heard last at 2.9 s";
  sequence = newest;
  beat(4);
  EXPECT_TRUE(contacts.isSteady(kOther, 0.5, 4.5));
}

TEST_F(ContactsTest, AnotherGenerationHasNoSay) {
  gravity_wells::heartbeat_t heartbeat{};
  heartbeat.header.peer_id = 2;
  heartbeat.header.incarnation = 22;
  heartbeat.header.sequence = 1;
  heartbeat.header.generation_founded = 99;
  heartbeat.phase = gravity_wells::heartbeat_t::ACTIVE;
  contacts.hear(heartbeat, kGeneration, 0);
  EXPECT_TRUE(contacts.hearsOnly({}, 4, 0));
}

}  // namespace
}  // namespace wells::simulation
