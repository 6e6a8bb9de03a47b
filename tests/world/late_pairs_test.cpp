#include "world/late_pairs.h"

#include <gtest/gtest.h>

#include <vector>

namespace wells {
namespace {

/// Balls of radius 0.5 m in a row, `apart` m from centre to centre, in steps that change nothing.
struct Row {
  Row(std::size_t count, double apart) {
    for (std::size_t i = 0; i < count; ++i)
      world.balls.add({.position = {apart * static_cast<double>(i), 1, 0}}, 0.5, 1);
  }

  std::int64_t step(const std::vector<BallPair>& pairs, const std::vector<std::uint32_t>& awake) {
    std::vector<Candidates::Sphere> start;
    for (const Vec3& position : world.balls.position) start.push_back({position, 0});
    const std::int64_t count = late.count(world, pairs, start, awake, alone);
    ++world.step;
    return count;
  }

  World world;
  LatePairs late;
  ThreadPool alone;
};

TEST(LatePairs, CountsAPairThatIsAnnouncedInOverlap) {
  Row row(3, 0.9);
  EXPECT_EQ(row.step({{0, 1}}, {0, 1, 2}), 0);  // nobody has been there before
  EXPECT_EQ(row.step({{0, 1}, {1, 2}}, {0, 1, 2}), 1);
  EXPECT_EQ(row.step({{0, 1}, {1, 2}}, {0, 1, 2}), 0);  // known now
}

TEST(LatePairs, CountsAgainWhatWasForgotten) {
  Row row(4, 0.9);
  row.step({{0, 1}, {1, 2}, {2, 3}}, {0, 1, 2, 3});
  EXPECT_EQ(row.step({{1, 2}}, {0, 1, 2, 3}), 0);
  EXPECT_EQ(row.step({{0, 1}, {1, 2}, {2, 3}}, {0, 1, 2, 3}), 2);
}

TEST(LatePairs, LetsBallsTouchWhenTheyAreAnnounced) {
  for (const double apart : {1.5, 1.0, 1 - 0.9e-6}) {
    Row row(2, apart);
    row.step({}, {0, 1});
    EXPECT_EQ(row.step({{0, 1}}, {0, 1}), 0) << apart;
  }
  Row row(2, 1 - 1.1e-6);
  row.step({}, {0, 1});
  EXPECT_EQ(row.step({{0, 1}}, {0, 1}), 1);
}

TEST(LatePairs, DoesNotCountBallsThatWereAsleep) {
  for (const std::uint32_t awake : {0u, 1u}) {
    Row row(2, 0.9);
    row.step({}, {0, 1});
    row.step({}, {awake});
    EXPECT_EQ(row.step({{0, 1}}, {0, 1}), 0);
  }
}

TEST(LatePairs, DoesNotCountOtherPeersBalls) {
  for (const std::size_t ghost : {0, 1}) {
    Row row(2, 0.9);
    row.world.roles = {Role::Owned, Role::Owned};
    row.world.roles[ghost] = Role::Ghost;
    row.step({}, {0, 1});
    EXPECT_EQ(row.step({{0, 1}}, {0, 1}), 0);
  }
}

}  // namespace
}  // namespace wells
