// Digests of what a peer knows of the ownership of 256 balls at a time. Two peers whose digests
// agree know the same versions (but for steps, which rise all the time). Pure functions.
//
// A digest says which balls it counts: where balls change hands often, two peers would otherwise
// hardly ever know the same of all 256 at one moment.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ownership/records.h"

namespace wells {

inline constexpr std::size_t kBallsInBucket = 256;

struct BucketDigest {
  std::bitset<kBallsInBucket> known;  // balls that count, by their place in the bucket
  std::uint64_t sum = 0;              // of their hashes, modulo 2^64

  bool operator==(const BucketDigest&) const = default;
};

constexpr std::size_t bucketCount(std::size_t balls) {
  return (balls + kBallsInBucket - 1) / kBallsInBucket;
}

/// Of a ball's version without its step; whoever owns it, named or heard.
std::uint64_t tenureHash(std::size_t ball, const Version& version);

/// The sum for `bucket` over the balls in `known`; what lies beyond the last record does not count.
std::uint64_t digestSum(std::span<const Record> records, std::size_t bucket,
                        const std::bitset<kBallsInBucket>& known);

}  // namespace wells
