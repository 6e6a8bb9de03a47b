#include "network/gathering.h"

#include <gtest/gtest.h>

#include <vector>

namespace wells {
namespace {

const Generation kGeneration{0, 1000, 1};
const Incarnation kA{PeerId{1}, 11};
const Incarnation kB{PeerId{2}, 22};
const std::vector<Incarnation> kPeers{kA};

class GatheringTest : public ::testing::Test {
 protected:
  BucketDigest digestOf(std::initializer_list<std::size_t> balls) const {
    BucketDigest digest;
    for (const std::size_t ball : balls) digest.known.set(ball);
    digest.sum = digestSum(theirs_, 0, digest.known);
    return digest;
  }

  void compare(const Incarnation& peer, const BucketDigest& digest, double now,
               std::int64_t recent) {
    gathering_.compare(ours_, peer, 0, digest, now, [&](const Record& record, std::int64_t step) {
      return step >= recent && record.version.owner == living_;
    });
  }

  Incarnation living_ = kA;
  std::vector<Record> ours_{3, found(kGeneration, kA, 0)};
  std::vector<Record> theirs_ = ours_;
  Gathering gathering_{3};
};

TEST_F(GatheringTest, KnowsWhatIsHeldAndWhenItAgreed) {
  EXPECT_EQ(gathering_.missing(), 3u);
  gathering_.hear(0, 5);
  gathering_.hear(1, 6);
  EXPECT_EQ(gathering_.missing(), 1u);
  EXPECT_TRUE(gathering_.has(1));
  EXPECT_FALSE(gathering_.has(2));
  gathering_.hear(2, 4);
  EXPECT_EQ(gathering_.missing(), 0u);
  compare(kA, digestOf({0, 1, 2}), 1.0, 100);
  EXPECT_TRUE(gathering_.agrees(kPeers, 0));
  EXPECT_FALSE(gathering_.agrees(kPeers, 1.05)) << "that was confirmed too long ago";
  EXPECT_EQ(gathering_.latestStep(), 6);
}

TEST_F(GatheringTest, HearingAStateIsNotEnough) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 5);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0));
}

TEST_F(GatheringTest, ADigestThatDiffersConfirmsNothing) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 5);
  compare(kA, digestOf({0, 1, 2}), 1.0, 100);
  EXPECT_TRUE(gathering_.agrees(kPeers, 1.0));
  theirs_[1].version.owner = kB;
  theirs_[1].version.epoch = 1;
  compare(kA, digestOf({0, 1, 2}), 2.0, 100);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0));
}

TEST_F(GatheringTest, WhatADigestDoesNotCountIsLeftToALaterOne) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 5);
  compare(kA, digestOf({0, 2}), 2.0, 100);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0)) << "nothing has been said of ball 1";
  compare(kA, digestOf({0, 1}), 2.1, 100);
  EXPECT_TRUE(gathering_.agrees(kPeers, 2.0));
  EXPECT_FALSE(gathering_.agrees(kPeers, 2.05)) << "ball 2 is not in the last one";
}

TEST_F(GatheringTest, OfWhatADigestDoesNotCountARecentStateIsEnough) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 100);
  compare(kA, digestOf({0, 2}), 2.0, 101);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0));
  compare(kA, digestOf({0, 2}), 2.0, 100);
  EXPECT_TRUE(gathering_.agrees(kPeers, 0));
}

TEST_F(GatheringTest, AStateFromAnOwnerThatIsGoneSaysNothing) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 100);
  living_ = kB;
  compare(kA, digestOf({0, 2}), 2.0, 100);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0)) << "somebody adopts it";
}

TEST_F(GatheringTest, ABallThatTheOtherHasJustAdoptedDoesNotHideThatWeKnewAnOldOwner) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 5);
  theirs_[1].version.epoch = 1;
  compare(kA, digestOf({0, 1, 2}), 1.0, 100);
  theirs_[1].version.term = 1;
  compare(kA, digestOf({0, 2}), 1.1, 100);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0));
}

TEST_F(GatheringTest, AgreesWithAllWhoAreNamed) {
  for (std::size_t ball = 0; ball < 3; ++ball) gathering_.hear(ball, 5);
  compare(kA, digestOf({0, 1, 2}), 1.0, 100);
  const std::vector<Incarnation> both{kA, kB};
  EXPECT_FALSE(gathering_.agrees(both, 0));
  compare(kB, digestOf({0, 1, 2}), 1.0, 100);
  EXPECT_TRUE(gathering_.agrees(both, 0));
}

TEST_F(GatheringTest, StatesFromBeforeAreHeldAndNotConfirmed) {
  gathering_.keep(100);
  EXPECT_EQ(gathering_.missing(), 0u);
  EXPECT_EQ(gathering_.stepOf(1), 100);
  EXPECT_FALSE(gathering_.agrees(kPeers, 0));
  gathering_.restart();
  EXPECT_EQ(gathering_.missing(), 3u);
}

}  // namespace
}  // namespace wells
