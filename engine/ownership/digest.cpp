#include "ownership/digest.h"

#include <algorithm>

#include "math/hash.h"

namespace wells {

std::uint64_t tenureHash(std::size_t ball, const Version& v) {
  Hash hash;
  for (const std::int64_t part :
       {static_cast<std::int64_t>(ball), v.generation.resets, v.generation.foundedUs,
        v.generation.nonce, v.term, static_cast<std::int64_t>(value(v.adopter.peer)),
        v.adopter.number, v.epoch, static_cast<std::int64_t>(value(v.owner.peer)), v.owner.number})
    hash.add(static_cast<std::uint64_t>(part));
  return hash.value();
}

std::uint64_t digestSum(std::span<const Record> records, std::size_t bucket,
                        const std::bitset<kBallsInBucket>& known) {
  const std::size_t first = bucket * kBallsInBucket;
  const std::size_t end = std::min(first + kBallsInBucket, records.size());
  std::uint64_t sum = 0;
  for (std::size_t ball = first; ball < end; ++ball)
    if (known[ball - first]) sum += tenureHash(ball, records[ball].version);
  return sum;
}

}  // namespace wells
