// A picture in memory, and PNG files of it. Knows nothing of the world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace wells {

struct Image {
  int width = 0;                  // pixels
  int height = 0;                 // pixels
  std::vector<std::uint8_t> rgb;  // sRGB, 3 bytes a pixel, top row first, no padding
};

struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;  // sRGB

  bool operator==(const Color&) const = default;
};

inline Image makeImage(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 3)};
}

inline std::uint8_t* pixelAt(Image& image, int x, int y) {
  return image.rgb.data() + (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 3;
}

inline Color colorAt(const Image& image, int x, int y) {
  const std::size_t at = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 3;
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// Mixes `color` into pixel (x, y) with `alpha` in 0 .. 1; outside the image it does nothing.
void blendPixel(Image& image, int x, int y, Color color, double alpha);

/// Writes `image` so that a reader sees the old file or the whole new one, never a part. Throws
/// std::runtime_error with the path and the reason.
void writePng(const Image& image, const std::filesystem::path& path);

}  // namespace wells
