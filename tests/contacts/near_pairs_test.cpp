#include "contacts/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contacts/substep_rules.h"
#include "math/random.h"
#include "math/vector.h"

namespace wells {
namespace {

constexpr double kStep = 0.1;  // s

bool isEqual(const IndexPair& x, const IndexPair& y) {
  return x.a == y.a && x.b == y.b;
}

/// Balls at random, given in the reverse order of their ids, and all pairs of them.
struct Crowd {
  explicit Crowd(std::uint32_t count) {
    Random random(count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const Vec3 x(random.uniform(0, 4), random.uniform(0, 2), random.uniform(0, 4));
      const Vec3 v = random.uniform(0, 9) * random.direction();
      places.push_back({x.x(), x.y(), x.z(), random.uniform(0.1, 0.3)});
      momenta.push_back({.vx = v.x(), .vy = v.y(), .vz = v.z()});
      balls.push_back(count - 1 - k);
      place.push_back(count - 1 - k);
    }
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b) pairs.push_back({a, b});
  }

  NearPairs divided(int threads) {
    ThreadPool pool(threads);
    NearPairs divided;
    divided.find(pairs, balls, place, kStep, places.data(), momenta.data(), pool);
    return divided;
  }

  /// Of the way that two balls come close, how much is beyond kFarGap (m), at the best of many
  /// moments.
  double beyondFarGap(const IndexPair& pair) const {
    constexpr int kMoments = 1000;
    const Place& a = places[pair.a];
    const Place& b = places[pair.b];
    const Momentum& p = momenta[pair.a];
    const Momentum& q = momenta[pair.b];
    double least = 1e9;
    for (int n = 0; n <= kMoments; ++n) {
      const double t = kStep * n / kMoments;
      least = std::min(least,
                       length(Vec3(b.x + q.vx * t - a.x - p.vx * t, b.y + q.vy * t - a.y - p.vy * t,
                                   b.z + q.vz * t - a.z - p.vz * t)));
    }
    return least - (a.radius + b.radius) * (1 + kFarGap);
  }

  std::vector<Place> places;
  std::vector<Momentum> momenta;
  std::vector<std::uint32_t> balls;
  std::vector<std::uint32_t> place;
  std::vector<BallPair> pairs;
};

constexpr double kBetweenMoments = 1e-3;  // m, what the best of many moments may miss

TEST(NearPairs, AreThoseThatComeClose) {
  Crowd crowd(150);
  NearPairs divided = crowd.divided(1);
  const auto near = divided.near().pairs;
  const auto far = divided.far(0);
  EXPECT_GT(near.size(), 100u);
  EXPECT_GT(far.size(), 100u);
  for (const IndexPair& pair : near) EXPECT_LE(crowd.beyondFarGap(pair), kBetweenMoments);
  for (const IndexPair& pair : far) EXPECT_GE(crowd.beyondFarGap(pair), 0);
}

TEST(NearPairs, WithFarOnesAreAllPairs) {
  Crowd crowd(150);
  NearPairs divided = crowd.divided(1);
  const auto near = divided.near().pairs;
  std::vector<BallPair> all;
  for (const auto& part : {near, std::span<const IndexPair>(divided.far(0))})
    for (const auto& [a, b] : part) all.push_back({crowd.balls[a], crowd.balls[b]});
  std::ranges::sort(
      all, [](const BallPair& x, const BallPair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  EXPECT_TRUE(std::ranges::equal(all, crowd.pairs));
}

TEST(NearPairs, AreListedByBall) {
  Crowd crowd(150);
  const NearPairs divided = crowd.divided(1);
  const auto [pairs, firstOf] = divided.near();
  ASSERT_EQ(firstOf.size(), crowd.balls.size() + 1);
  EXPECT_EQ(firstOf.front(), 0u);
  EXPECT_EQ(firstOf.back(), pairs.size());
  for (std::uint32_t k = 0; k < crowd.balls.size(); ++k)
    for (std::uint32_t n = firstOf[k]; n < firstOf[k + 1]; ++n) EXPECT_EQ(pairs[n].a, k);
}

TEST(NearPairs, AreTheSameForAnyNumberOfThreads) {
  Crowd crowd(1700);
  NearPairs alone = crowd.divided(1);
  for (const int threads : {2, 3}) {
    NearPairs divided = crowd.divided(threads);
    EXPECT_TRUE(std::ranges::equal(divided.near().pairs, alone.near().pairs, isEqual));
    EXPECT_TRUE(std::ranges::equal(divided.near().firstOf, alone.near().firstOf));
    std::vector<IndexPair> far;
    for (std::size_t thread = 0; thread < static_cast<std::size_t>(threads); ++thread)
      far.insert(far.end(), divided.far(thread).begin(), divided.far(thread).end());
    EXPECT_TRUE(std::ranges::equal(far, alone.far(0), isEqual));
  }
}

TEST(NearPairs, OfNothingAreNone) {
  Crowd crowd(3);
  crowd.pairs.clear();
  NearPairs divided = crowd.divided(2);
  EXPECT_TRUE(divided.near().pairs.empty());
  EXPECT_TRUE(divided.far(0).empty());
  EXPECT_EQ(divided.near().firstOf.size(), 4u);
}

}  // namespace
}  // namespace wells
