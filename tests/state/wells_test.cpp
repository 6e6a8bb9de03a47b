#include "state/wells.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

WellTrack threeKeys() {
  return {.keyframes = {{10, {0, 1, 0}, 5}, {20, {10, 1, 0}, 7}, {30, {10, 1, 4}, 0}},
          .softening = 1.5,
          .peer = PeerId{3}};
}

TEST(WellTrack, RestsBeforeTheFirstAndAfterTheLastKeyframe) {
  const WellTrack track = threeKeys();
  EXPECT_EQ(wellAt(track, 3, 0.1).position, Vec3(0, 1, 0));
  EXPECT_EQ(wellAt(track, 3, 0.1).velocity, Vec3(0, 0, 0));
  EXPECT_EQ(wellAt(track, 3, 0.1).strength, 5);
  EXPECT_EQ(wellAt(track, 30, 0.1).position, Vec3(10, 1, 4));
  EXPECT_EQ(wellAt(track, 99, 0.1).velocity, Vec3(0, 0, 0));
  EXPECT_EQ(wellAt(track, 99, 0.1).strength, 0);
}

TEST(WellTrack, IsLinearBetweenKeyframes) {
  const Well well = wellAt(threeKeys(), 13, 0.1);
  EXPECT_EQ(well.position, Vec3(3, 1, 0));
  EXPECT_EQ(well.velocity, Vec3(10, 0, 0));  // 10 m in 10 steps of 0.1 s
  EXPECT_EQ(well.strength, 5);
  EXPECT_EQ(well.softening, 1.5);
  EXPECT_EQ(well.peer, PeerId{3});
  EXPECT_EQ(wellAt(threeKeys(), 20, 0.1).strength, 7);
}

TEST(WellTrack, EndOfAStepIsTheStartOfTheNext) {
  const WellTrack track = threeKeys();
  for (std::int64_t step = 5; step < 40; ++step) {
    const Well now = wellAt(track, step, 0.1);
    const Well next = wellAt(track, step + 1, 0.1);
    EXPECT_LE(length(now.position + now.velocity * 0.1 - next.position), 1e-14) << step;
  }
}

TEST(CirclePath, GoesRound) {
  const CirclePath path{.center = {1, 2, 3}, .radius = 4, .period = 8};
  EXPECT_EQ(positionOnCircle(path, 0), Vec3(5, 2, 3));
  EXPECT_EQ(positionOnCircle(path, 2), Vec3(1, 2, 7));
  EXPECT_EQ(positionOnCircle(path, 12), Vec3(-3, 2, 3));
}

}  // namespace
}  // namespace wells
