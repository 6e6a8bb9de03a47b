#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "render/palette.h"

namespace wells {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

struct Pixel {
  int x, y;
};

Pixel pixelOf(const Camera& camera, const Vec3& point) {
  const auto at = project(camera, kAspect, point);
  if (!at) throw std::logic_error("the test's point is behind the eye");
  return {static_cast<int>((1 + at->x()) / 2 * kWidth),
          static_cast<int>((1 - at->y()) / 2 * kHeight)};
}

/// The peer whose colour comes nearest in hue and saturation, brightness left out; 0 for grey.
int peerSeen(Color color) {
  const auto direction = [](Color c) {
    const auto square = [](std::uint8_t v) { return std::pow(v / 255.0, 2); };
    return Vec3{square(c.red), square(c.green), square(c.blue)}.normalized();
  };
  int best = -1;
  double bestMatch = -std::numeric_limits<double>::infinity();
  for (int peer = 0; peer <= 4; ++peer) {
    const double match = direction(color).dot(direction(peerColor(peer)));
    if (match > bestMatch) {
      bestMatch = match;
      best = peer;
    }
  }
  return best;
}

Image drawn(const View& view, const Camera& camera) {
  Renderer renderer(kWidth, kHeight);
  Image image;
  renderer.draw(view, camera, image);
  return image;
}

double meanDifference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(a.rgb.size());
}

View arenaWithoutBalls() {
  View view;
  view.arena = {Vec3::Zero(), 10};
  view.radius = {0.8};
  return view;
}

View fourBalls() {
  View view = arenaWithoutBalls();
  view.position = {Vec3{-5, 0.8, 2}, Vec3{4, 0.8, 3}, Vec3{0, 4, -2}, Vec3{1, 0.8, 6}};
  view.owner = {1, 2, 3, 4};
  return view;
}

TEST(Renderer, BallsHaveTheirOwnersColour) {
  const View view = fourBalls();
  const Camera camera = cameraOverArena(view.arena, kAspect);
  const Image image = drawn(view, camera);
  EXPECT_EQ(image.width, kWidth);
  EXPECT_EQ(image.height, kHeight);
  for (std::size_t i = 0; i < view.position.size(); ++i) {
    const Pixel pixel = pixelOf(camera, view.position[i]);
    EXPECT_EQ(peerSeen(colorAt(image, pixel.x, pixel.y)), view.owner[i]) << "ball " << i;
  }
}

TEST(Renderer, RemovedBallIsGone) {
  View view = fourBalls();
  const Camera camera = cameraOverArena(view.arena, kAspect);
  const Pixel pixel = pixelOf(camera, view.position[0]);
  view.position.erase(view.position.begin());
  view.owner.erase(view.owner.begin());
  const Image image = drawn(view, camera);
  EXPECT_EQ(peerSeen(colorAt(image, pixel.x, pixel.y)), 0);  // the ground is grey
}

TEST(Renderer, NearerBallHidesTheFartherInEitherOrder) {
  View view = arenaWithoutBalls();
  const Camera camera{Vec3{0, 1, 9}, Vec3{0, 1, 0}, 40};
  view.position = {Vec3{0, 1, -4}, Vec3{0, 1, 4}};
  view.owner = {1, 2};
  for (int order = 0; order < 2; ++order) {
    const Image image = drawn(view, camera);
    EXPECT_EQ(peerSeen(colorAt(image, kWidth / 2, kHeight / 2)), 2);
    std::swap(view.position[0], view.position[1]);
    std::swap(view.owner[0], view.owner[1]);
  }
}

TEST(Renderer, BallCoversTheDiscOfItsTangentCone) {
  View view = arenaWithoutBalls();
  view.radius = {2.0};
  view.position = {Vec3{0, 3, 0}};
  view.owner = {2};
  const Camera camera{Vec3{0, 3, 4}, Vec3{0, 3, 0}, 80};
  const Image image = drawn(view, camera);
  const double tangent = 2 / std::sqrt(4.0 * 4 - 2 * 2);
  const double radius = tangent / std::tan(std::numbers::pi / 4.5) * kHeight / 2;  // pixels
  for (int x = 0; x < kWidth; ++x) {
    const double from = std::abs(x + 0.5 - kWidth / 2.0);
    if (std::abs(from - radius) < 2) continue;
    const bool ball = peerSeen(colorAt(image, x, kHeight / 2)) == 2;
    EXPECT_EQ(ball, from < radius) << "column " << x;
  }
}

TEST(Renderer, BallsFarSmallerThanAPixelShow) {
  View view = arenaWithoutBalls();
  view.radius = {1e-3};
  view.position = {Vec3{-3, 0.5, 0}};
  view.owner = {1};
  const Camera camera = cameraOverArena(view.arena, kAspect);
  const Image image = drawn(view, camera);
  const Pixel pixel = pixelOf(camera, view.position[0]);
  EXPECT_EQ(peerSeen(colorAt(image, pixel.x, pixel.y)), 1);
}

TEST(Renderer, OwnersAreOptional) {
  View view = fourBalls();
  const Camera camera = cameraOverArena(view.arena, kAspect);
  view.owner.clear();
  const Image image = drawn(view, camera);
  const Image ground = drawn(arenaWithoutBalls(), camera);
  for (const Vec3& position : view.position) {
    const Pixel pixel = pixelOf(camera, position);
    EXPECT_EQ(peerSeen(colorAt(image, pixel.x, pixel.y)), 0);
    EXPECT_NE(colorAt(image, pixel.x, pixel.y), colorAt(ground, pixel.x, pixel.y));
  }
}

TEST(Renderer, FarAwayArenaLooksTheSame) {
  View view = fourBalls();
  view.wells = {{Vec3{-4, 1, -3}, 50, 1, 1}, {Vec3{5, 1, -2}, -50, 1, 2}};
  const Image near = drawn(view, cameraOverArena(view.arena, kAspect));

  const Vec3 away{1e6, -3e5, 2e6};
  view.arena.center += away;
  for (Vec3& position : view.position) position += away;
  for (ViewWell& well : view.wells) well.position += away;
  const Image far = drawn(view, cameraOverArena(view.arena, kAspect));
  EXPECT_LT(meanDifference(near, far), 0.01);  // of 255
}

TEST(Renderer, AttractingRepellingAndSwitchedOffWellsDiffer) {
  View view = arenaWithoutBalls();
  const Camera camera = cameraOverArena(view.arena, kAspect);
  std::vector<Image> images;
  for (const double strength : {50.0, -50.0, 0.0}) {
    view.wells = {{Vec3{0, 1, 0}, strength, 1, 1}};
    images.push_back(drawn(view, camera));
  }
  view.wells.clear();
  images.push_back(drawn(view, camera));
  for (std::size_t a = 0; a < images.size(); ++a) {
    for (std::size_t b = a + 1; b < images.size(); ++b) {
      EXPECT_GT(meanDifference(images[a], images[b]), 0.02) << a << " and " << b;
    }
  }
}

TEST(Renderer, SeveralInOneThreadKeepTheirPicturesApart) {
  const View view = fourBalls();
  const Camera camera = cameraOverArena(view.arena, kAspect);
  Renderer first(kWidth, kHeight), second(kWidth, kHeight);
  Image a, b, c;
  first.draw(view, camera, a);
  second.draw(arenaWithoutBalls(), camera, b);
  first.draw(view, camera, c);
  EXPECT_EQ(a.rgb, c.rgb);
  EXPECT_NE(a.rgb, b.rgb);
}

TEST(Renderer, RefusesWhatItCannotDraw) {
  EXPECT_THROW(Renderer(0, 100), std::runtime_error);
  EXPECT_THROW(Renderer(100, 1 << 20), std::runtime_error);
  View view = fourBalls();
  view.owner.pop_back();
  EXPECT_THROW(drawn(view, cameraOverArena(view.arena, kAspect)), std::invalid_argument);
}

}  // namespace
}  // namespace wells
