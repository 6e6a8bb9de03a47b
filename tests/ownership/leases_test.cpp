#include "ownership/leases.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

const Incarnation kPeer{PeerId{1}, 11};
const Incarnation kNewer{PeerId{1}, 12};
constexpr double kLease = 2;  // s

TEST(Leases, LastsAsLongAsTheStepAdvances) {
  Leases leases;
  for (int i = 0; i <= 10; ++i) leases.hear(kPeer, i, Progress::Running, kLease, i);
  EXPECT_TRUE(leases.isLiving(kPeer, 11.9));
  EXPECT_FALSE(leases.isLiving(kPeer, 12));
  EXPECT_EQ(leases.endedAt(kPeer, 50), 12);
}

TEST(Leases, APeerThatOnlyTalksIsGone) {
  Leases leases;
  for (int i = 0; i <= 10; ++i) leases.hear(kPeer, 7, Progress::Running, kLease, i);
  EXPECT_EQ(leases.endedAt(kPeer, 10), kLease);
}

TEST(Leases, OneThatStandsStillOnPurposeIsNot) {
  Leases leases;
  for (int i = 0; i <= 10; ++i) leases.hear(kPeer, 7, Progress::Paused, kLease, i);
  EXPECT_TRUE(leases.isLiving(kPeer, 11));
}

TEST(Leases, AMessageThatWasOvertakenRenewsNothing) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  leases.hear(kPeer, 9, Progress::Running, kLease, 1);
  EXPECT_EQ(leases.endedAt(kPeer, 5), kLease);
}

TEST(Leases, ASuspicionThatWasWrongIsTakenBack) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  EXPECT_FALSE(leases.isLiving(kPeer, 5));
  EXPECT_TRUE(leases.hear(kPeer, 11, Progress::Running, kLease, 5));
  EXPECT_TRUE(leases.isLiving(kPeer, 6));
}

TEST(Leases, AGoodByeIsForGood) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  leases.end(kPeer, 1);
  EXPECT_EQ(leases.endedAt(kPeer, 1), 1);
  EXPECT_FALSE(leases.hear(kPeer, 11, Progress::Running, kLease, 1.1));
  EXPECT_TRUE(leases.isOver(kPeer));
  EXPECT_EQ(leases.endedAt(kPeer, 9), 1) << "and when it ended does not change";
}

TEST(Leases, AGoodByeOfOneWhoIsUnknownEndsNow) {
  Leases leases;
  leases.end(kPeer, 7);
  EXPECT_EQ(leases.endedAt(kPeer, 8), 7);
}

TEST(Leases, ANewIncarnationEndsTheOldOneThatIsSilentAndDoesNotRenewIt) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  leases.supersede(kNewer, 0.51 * kLease);
  leases.hear(kNewer, 11, Progress::Running, kLease, 0.51 * kLease);
  EXPECT_EQ(leases.endedAt(kPeer, 0.51 * kLease), 0.51 * kLease);
  EXPECT_EQ(leases.endedAt(kPeer, 0.9 * kLease), 0.51 * kLease);
  EXPECT_TRUE(leases.isLiving(kNewer, kLease));
}

TEST(Leases, AnotherIncarnationEndsNoneThatIsStillHeard) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  leases.supersede(kNewer, 0.49 * kLease);
  EXPECT_TRUE(leases.isLiving(kPeer, 0.9 * kLease)) << "two machines have one id";
}

TEST(Leases, AnOldIncarnationThatOutlivesTheNewOneMayBeHeardAgain) {
  Leases leases;
  leases.hear(kPeer, 10, Progress::Running, kLease, 0);
  leases.supersede(kNewer, 0.6 * kLease);
  EXPECT_FALSE(leases.hear(kPeer, 10, Progress::Running, kLease, 5)) << "it must have advanced";
  EXPECT_TRUE(leases.hear(kPeer, 11, Progress::Running, kLease, 5));
  EXPECT_TRUE(leases.isLiving(kPeer, 6));
}

TEST(Leases, OneWhoIsOnlyNamedHasOneLeaseToShowItself) {
  Leases leases;
  leases.expect(kPeer, kLease, 3);
  leases.expect(kPeer, kLease, 4);  // naming it again is no sign of life
  EXPECT_TRUE(leases.isLiving(kPeer, 4.9));
  EXPECT_EQ(leases.endedAt(kPeer, 5), 5);
  EXPECT_TRUE(leases.hear(kPeer, 0, Progress::Running, kLease, 5));
}

TEST(Leases, ForgetsOnlyWhatEndedLongAgo) {
  Leases leases;
  leases.hear(kPeer, 1, Progress::Running, kLease, 0);
  leases.hear(kNewer, 1, Progress::Running, kLease, 99);
  leases.end(kPeer, 1);
  leases.forget(0.5, 100);
  EXPECT_TRUE(leases.isOver(kPeer));
  leases.forget(50, 100);
  EXPECT_FALSE(leases.isOver(kPeer));
  EXPECT_TRUE(leases.isLiving(kNewer, 100));
}

TEST(Leases, AnOwnerWhoseLoopStoodStillForMoreThanHalfALeaseMustFence) {
  EXPECT_FALSE(mustFence(10, 11, kLease));
  EXPECT_TRUE(mustFence(10, 11.001, kLease));
}

}  // namespace
}  // namespace wells
