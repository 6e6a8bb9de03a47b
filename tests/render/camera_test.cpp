#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wells {
namespace {

class CameraOverArena : public testing::TestWithParam<double> {};

TEST_P(CameraOverArena, SeesTheWholeRimAndLittleMore) {
  for (const double radius : {0.5, 40.0, 5000.0}) {
    const Arena arena{Vec3{12, -7, 1e6}, radius};
    const Camera camera = cameraOverArena(arena, GetParam());
    double widest = 0, highest = 0;
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * std::numbers::pi / 180;
      for (const double height : {0.0, rimHeight(arena)}) {
        const auto at = project(
            camera, GetParam(),
            arena.center + Vec3{radius * std::cos(angle), height, radius * std::sin(angle)});
        ASSERT_TRUE(at);
        widest = std::max(widest, std::abs(at->x()));
        highest = std::max(highest, std::abs(at->y()));
      }
    }
    EXPECT_LE(std::max(widest, highest), 0.96);
    EXPECT_GE(std::max(widest, highest), 0.94);
  }
}

INSTANTIATE_TEST_SUITE_P(Aspects, CameraOverArena,
                         testing::Values(4.0 / 3, 16.0 / 9, 1.0, 0.5, 3.0));

TEST(Camera, ProjectsAsTheTangentsSay) {
  const Camera camera{Vec3{1, 2, 10}, Vec3{1, 2, 0}, 90};
  const auto middle = project(camera, 2, Vec3{1, 2, -5});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->norm(), 0, 1e-12);
  // 5 m to the right and 2 m up at 10 m; the half height is 10 m there, the half width 20 m.
  const auto aside = project(camera, 2, Vec3{6, 4, 0});
  ASSERT_TRUE(aside);
  EXPECT_NEAR(aside->x(), 0.25, 1e-12);
  EXPECT_NEAR(aside->y(), 0.2, 1e-12);
  EXPECT_FALSE(project(camera, 2, Vec3{1, 2, 11}));
}

TEST(Camera, LookingStraightDownHasNorthUp) {
  const Camera camera{Vec3{0, 30, 0}, Vec3::Zero(), 60};
  const auto north = project(camera, 1, Vec3{0, 0, -5});
  ASSERT_TRUE(north);
  EXPECT_NEAR(north->x(), 0, 1e-12);
  EXPECT_GT(north->y(), 0);
}

}  // namespace
}  // namespace wells
