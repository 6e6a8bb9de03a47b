#include "contacts/near_pairs.h"

#include <algorithm>

namespace wells {
namespace {

constexpr std::size_t kLeastPairs = 4096;  // that a thread goes through
constexpr std::size_t kLeastBalls = 512;   // likewise
constexpr std::size_t kBlock = 1024;       // pairs, about, that are looked at while in the cache

}  // namespace

void NearPairs::find(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                     std::span<const std::uint32_t> place, double duration, const Place* places,
                     const Momentum* momenta, ThreadPool& pool) {
  // Pairs of one ball a follow each other in both orders.
  runOf_.assign(balls.size(), {});
  pool.forRanges(pairs.size(), kLeastPairs, [&](std::size_t begin, std::size_t end, std::size_t) {
    while (begin > 0 && begin < end && pairs[begin].a == pairs[begin - 1].a) ++begin;
    for (std::size_t n = begin; n < end;) {
      const std::size_t first = n;
      while (n < pairs.size() && pairs[n].a == pairs[first].a) ++n;
      runOf_[place[pairs[first].a]] = {static_cast<std::uint32_t>(first),
                                       static_cast<std::uint32_t>(n - first)};
    }
  });

  firstOf_.resize(balls.size() + 1);
  firstOf_[0] = 0;
  const std::size_t parts = pool.ranges(balls.size(), kLeastBalls);
  for (Part& part : std::span(parts_).subspan(parts)) part.far.clear();
  pool.forRanges(balls.size(), kLeastBalls,
                 [&](std::size_t begin, std::size_t end, std::size_t range) {
                   divide(pairs, place, duration, places, momenta, {begin, end}, parts_[range]);
                 });

  // What the threads found, one after the other.
  std::size_t count = 0;
  for (const Part& part : std::span(parts_).first(parts)) count += part.near.size();
  near_.resize(count);
  pool.forRanges(
      balls.size(), kLeastBalls, [&](std::size_t begin, std::size_t end, std::size_t range) {
        std::size_t before = 0;
        for (std::size_t n = 0; n < range; ++n) before += parts_[n].near.size();
        std::ranges::copy(parts_[range].near, near_.begin() + static_cast<std::ptrdiff_t>(before));
        for (std::size_t k = begin; k < end; ++k)
          firstOf_[k + 1] += static_cast<std::uint32_t>(before);
      });
}

void NearPairs::divide(std::span<const BallPair> pairs, std::span<const std::uint32_t> place,
                       double duration, const Place* places, const Momentum* momenta,
                       IndexRange balls, Part& part) {
  std::size_t near = 0;
  std::size_t far = 0;
  std::size_t next = balls.begin;
  while (next < balls.end) {
    const std::size_t first = next;
    part.block.clear();
    for (; next < balls.end && part.block.size() < kBlock; ++next)
      for (const BallPair& pair : pairs.subspan(runOf_[next].first, runOf_[next].count))
        part.block.push_back({static_cast<std::uint32_t>(next), place[pair.b]});
    part.isNear.resize(part.block.size());
    findNear(duration, places, momenta, part.block, part.isNear.data());

    // Without a branch for each: whether a pair is near cannot be foretold.
    part.near.resize(std::max(part.near.size(), near + part.block.size()));
    part.far.resize(std::max(part.far.size(), far + part.block.size()));
    std::size_t n = 0;
    for (std::size_t k = first; k < next; ++k) {
      for (const std::size_t last = n + runOf_[k].count; n < last; ++n) {
        part.near[near] = part.far[far] = part.block[n];
        near += part.isNear[n];
        far += 1 - part.isNear[n];
      }
      firstOf_[k + 1] = static_cast<std::uint32_t>(near);
    }
  }
  part.near.resize(near);
  part.far.resize(far);
}

}  // namespace wells
