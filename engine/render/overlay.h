// What is written over the picture: the legend in the upper left corner and the wells' labels.
#pragma once

#include "render/camera.h"
#include "render/font.h"
#include "render/image.h"
#include "render/view.h"

namespace wells {

/// Pixels of an image, right and bottom excluded.
struct Box {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// The text size (pixels) that suits pictures of this height (pixels).
int textSizeFor(int imageHeight);

/// Where drawLegend draws, and it draws nowhere else; empty without title and legend.
Box legendBox(const View& view, Font& font);
void drawLegend(Image& image, const View& view, Font& font);

/// The peer's number at the top of each well's beam.
void drawWellLabels(Image& image, const View& view, const Camera& camera, Font& font);

}  // namespace wells
