#include "render/overlay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "render/palette.h"
#include "render/well_pass.h"

namespace wells {
namespace {

constexpr Color kPanel{14, 17, 23};
constexpr double kPanelAlpha = 0.62;
constexpr Color kText{236, 240, 245};

/// Fills the box, its corners rounded with `radius` pixels.
void fillRounded(Image& image, const Box& box, double radius, Color color, double alpha) {
  const double middleX = 0.5 * (box.left + box.right), middleY = 0.5 * (box.top + box.bottom);
  const double coreX = 0.5 * (box.right - box.left) - radius;
  const double coreY = 0.5 * (box.bottom - box.top) - radius;
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double outX = std::max(0.0, std::abs(x + 0.5 - middleX) - coreX);
      const double outY = std::max(0.0, std::abs(y + 0.5 - middleY) - coreY);
      const double cover = std::clamp(radius - std::hypot(outX, outY) + 0.5, 0.0, 1.0);
      if (cover > 0) blendPixel(image, x, y, color, alpha * cover);
    }
  }
}

int margin(const Font& font) {
  return font.lineHeight() * 2 / 3;
}
int swatchSize(const Font& font) {
  return font.capitalHeight() + 2;
}
int textIndent(const Font& font) {
  return swatchSize(font) + font.lineHeight() / 2;
}

}  // namespace

int textSizeFor(int imageHeight) {
  return std::max(11, imageHeight / 50);
}

Box legendBox(const View& view, Font& font) {
  if (view.title.empty() && view.legend.empty()) return {};
  int width = 0;
  for (const std::string& line : view.title) width = std::max(width, font.width(line));
  for (const LegendRow& row : view.legend) {
    width = std::max(width, textIndent(font) + font.width(row.text));
  }
  const int lines = static_cast<int>(view.title.size() + view.legend.size());
  const int edge = margin(font);
  const int gap = view.title.empty() || view.legend.empty() ? 0 : edge / 2;
  return {edge, edge, 3 * edge + width, 3 * edge + gap + lines * font.lineHeight()};
}

void drawLegend(Image& image, const View& view, Font& font) {
  const Box box = legendBox(view, font);
  if (box.right == box.left) return;
  fillRounded(image, box, 0.6 * margin(font), kPanel, kPanelAlpha);

  const int left = box.left + margin(font);
  int baseline = box.top + margin(font) + (font.lineHeight() + font.capitalHeight()) / 2;
  for (const std::string& line : view.title) {
    font.draw(image, left, baseline, line, kText);
    baseline += font.lineHeight();
  }
  if (!view.title.empty()) baseline += margin(font) / 2;
  for (const LegendRow& row : view.legend) {
    const int size = swatchSize(font);
    const int top = baseline - font.capitalHeight() - 1;
    fillRounded(image, {left, top, left + size, top + size}, 0.5 * size, peerColor(row.peer), 1);
    font.draw(image, left + textIndent(font), baseline, row.text, kText);
    baseline += font.lineHeight();
  }
}

void drawWellLabels(Image& image, const View& view, const Camera& camera, Font& font) {
  const double aspect = static_cast<double>(image.width) / image.height;
  for (const ViewWell& well : view.wells) {
    if (well.peer <= 0 || well.strength == 0) continue;
    const auto at = project(camera, aspect, beamTop(view.arena, well));
    if (!at || std::abs(at->x()) > 1 || std::abs(at->y()) > 1) continue;
    const std::string text = std::to_string(well.peer);
    const int x = static_cast<int>(std::lround((1 + at->x()) / 2 * image.width));
    const int y = static_cast<int>(std::lround((1 - at->y()) / 2 * image.height));
    const int halfHeight = font.capitalHeight();
    const int halfWidth = std::max(halfHeight, font.width(text) / 2 + font.capitalHeight() / 2);
    const Box box{x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight};
    fillRounded(image, box, halfHeight, peerColor(well.peer), 1);
    const Box inner{box.left + 2, box.top + 2, box.right - 2, box.bottom - 2};
    fillRounded(image, inner, halfHeight - 2, kPanel, 0.85);
    font.draw(image, x - font.width(text) / 2, y + font.capitalHeight() / 2, text, kText);
  }
}

}  // namespace wells
