#include "ownership/digest.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace wells {
namespace {

const Generation kGeneration{0, 1000, 1};
const Incarnation kA{PeerId{1}, 11};
const Incarnation kB{PeerId{2}, 22};

std::vector<Record> foundedRecords(std::size_t balls) {
  return std::vector<Record>(balls, found(kGeneration, kA, 0));
}

std::bitset<kBallsInBucket> all() {
  return std::bitset<kBallsInBucket>().set();
}

TEST(Digest, CountsBucketsToTheLastBall) {
  EXPECT_EQ(bucketCount(0), 0u);
  EXPECT_EQ(bucketCount(1), 1u);
  EXPECT_EQ(bucketCount(256), 1u);
  EXPECT_EQ(bucketCount(257), 2u);
  EXPECT_EQ(bucketCount(100'000), 391u);
}

TEST(Digest, DiffersWithEveryPartOfAVersionButTheStep) {
  const Version version{kGeneration, 3, kA, 4, kB, 100};
  std::vector<Version> others(10, version);
  others[0].generation.resets = 1;
  others[1].generation.foundedUs = 999;
  others[2].generation.nonce = 2;
  others[3].term = 4;
  others[4].adopter = kB;
  others[5].adopter.number = 12;
  others[6].epoch = 5;
  others[7].owner = kA;
  others[8].owner.number = 23;
  others[9].adopter.peer = PeerId{4};
  std::set<std::uint64_t> hashes{tenureHash(7, version), tenureHash(8, version)};
  for (const Version& other : others) hashes.insert(tenureHash(7, other));
  EXPECT_EQ(hashes.size(), 12u);

  Version later = version;
  later.step = 101;
  EXPECT_EQ(tenureHash(7, later), tenureHash(7, version));
}

TEST(Digest, ShowsOneBallThatDiffersInAnyPlace) {
  const std::vector<Record> records = foundedRecords(300);
  for (const std::size_t ball : {0u, 255u, 256u, 299u}) {
    std::vector<Record> others = records;
    others[ball].version.owner = kB;
    const std::size_t bucket = ball / kBallsInBucket;
    EXPECT_NE(digestSum(others, bucket, all()), digestSum(records, bucket, all())) << ball;
    EXPECT_EQ(digestSum(others, 1 - bucket, all()), digestSum(records, 1 - bucket, all()));
    auto without = all();
    without.reset(ball % kBallsInBucket);
    EXPECT_EQ(digestSum(others, bucket, without), digestSum(records, bucket, without));
  }
}

TEST(Digest, TwoBallsThatSwapOwnersShow) {
  std::vector<Record> records = foundedRecords(2);
  records[1].version.owner = kB;
  std::vector<Record> swapped = foundedRecords(2);
  swapped[0].version.owner = kB;
  EXPECT_NE(digestSum(records, 0, all()), digestSum(swapped, 0, all()));
}

}  // namespace
}  // namespace wells
