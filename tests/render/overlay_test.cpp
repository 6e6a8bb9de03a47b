#include "render/overlay.h"

#include <gtest/gtest.h>

#include "render/palette.h"
#include "render/renderer.h"

namespace wells {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 300;

View viewWithLegend() {
  View view;
  view.title = {"t = 12.50 s", "physics 60.0 of 60 Hz"};
  view.legend = {{1, "peer 1   13 balls"}, {2, "peer 2   12 balls"}};
  return view;
}

TEST(Legend, ChangesPixelsInItsBoxOnly) {
  View view = viewWithLegend();
  const Camera camera = cameraOverArena(view.arena, static_cast<double>(kWidth) / kHeight);
  Font font(textSizeFor(kHeight));
  const Box box = legendBox(view, font);
  ASSERT_LT(box.left, box.right);

  Renderer renderer(kWidth, kHeight);
  Image with, without;
  renderer.draw(view, camera, with);
  view.title.clear();
  view.legend.clear();
  renderer.draw(view, camera, without);

  int changedInside = 0, changedOutside = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= box.left && x < box.right && y >= box.top && y < box.bottom;
      const bool changed = colorAt(with, x, y) != colorAt(without, x, y);
      (inside ? changedInside : changedOutside) += changed;
    }
  }
  EXPECT_EQ(changedOutside, 0);
  EXPECT_GT(changedInside, (box.right - box.left) * (box.bottom - box.top) * 9 / 10);
}

TEST(Legend, ShowsEachPeersColour) {
  const View view = viewWithLegend();
  Font font(textSizeFor(kHeight));
  Image image = makeImage(kWidth, kHeight);
  drawLegend(image, view, font);
  for (const LegendRow& row : view.legend) {
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) count += colorAt(image, x, y) == peerColor(row.peer);
    }
    EXPECT_GT(count, 20) << "peer " << row.peer;
  }
}

TEST(Legend, TooLargeForThePictureIsCut) {
  View view = viewWithLegend();
  view.title.push_back(std::string(500, 'W'));
  view.legend.resize(200, {3, "peer"});
  Font font(textSizeFor(kHeight));
  Image image = makeImage(kWidth, kHeight);
  drawLegend(image, view, font);
  EXPECT_NE(colorAt(image, kWidth - 1, kHeight - 1), (Color{0, 0, 0}));
}

TEST(WellLabels, StandWhereTheBeamEnds) {
  View view;
  view.wells = {{Vec3{0, 0.5, 0}, 100, 2, 2}};
  const double aspect = static_cast<double>(kWidth) / kHeight;
  const Camera camera = cameraOverArena(view.arena, aspect);
  Font font(textSizeFor(kHeight));
  Image image = makeImage(kWidth, kHeight);
  drawWellLabels(image, view, camera, font);

  const auto top = project(camera, aspect, Vec3{0, 0.2 * view.arena.radius, 0});
  ASSERT_TRUE(top);
  double sumX = 0, sumY = 0, count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (colorAt(image, x, y) == Color{}) continue;
      sumX += x + 0.5;
      sumY += y + 0.5;
      ++count;
    }
  }
  ASSERT_GT(count, 0);
  EXPECT_NEAR(sumX / count, (1 + top->x()) / 2 * kWidth, 1.5);
  EXPECT_NEAR(sumY / count, (1 - top->y()) / 2 * kHeight, 1.5);
}

TEST(Font, WidthGrowsWithTheTextAndCountsCharactersNotBytes) {
  Font font(20);
  EXPECT_EQ(font.width(""), 0);
  EXPECT_EQ(font.width("HH"), 2 * font.width("H"));
  EXPECT_LT(font.width("\xC3\x97"), 2 * font.width("H"));  // a multiplication sign
  EXPECT_GT(font.width("\xC3"), 0);                        // half of one: a box
  EXPECT_GT(font.width("\xFF\x80"), 0);
}

TEST(Font, DrawsWithinItsLineAndNotOutsideTheImage) {
  Font font(20);
  Image image = makeImage(60, 60);
  font.draw(image, 5, 40, "Hg", {255, 255, 255});
  int left = 60, right = -1, top = 60, bottom = -1;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      if (colorAt(image, x, y).red < 128) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  EXPECT_GE(left, 5);
  EXPECT_LE(right, 5 + font.width("Hg"));
  EXPECT_NEAR(top, 40 - font.capitalHeight(), 1);
  EXPECT_GT(bottom, 40);
  EXPECT_LT(bottom, 40 + 20 / 2);
  font.draw(image, -15, 3, "Hg", {255, 255, 255});
  font.draw(image, 55, 65, "Hg", {255, 255, 255});
}

}  // namespace
}  // namespace wells
