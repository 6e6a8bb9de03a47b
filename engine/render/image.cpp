#include "render/image.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

namespace wells {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error("cannot write the picture " + path.string() + ": " + reason);
}

void writePngTo(const std::filesystem::path& file, const Image& image) {
  std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "wb"));
  if (!stream) fail(file, std::strerror(errno));

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  if (png_image_write_to_stdio(&png, stream.get(), 0, image.rgb.data(), 0, nullptr) == 0) {
    fail(file, png.message);
  }
  // A full disk may show only when the last buffer is flushed.
  if (std::fclose(stream.release()) != 0) fail(file, std::strerror(errno));
}

}  // namespace

void blendPixel(Image& image, int x, int y, Color color, double alpha) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* pixel = pixelAt(image, x, y);
  const auto mix = [alpha](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround(below + (above - below) * alpha));
  };
  pixel[0] = mix(pixel[0], color.red);
  pixel[1] = mix(pixel[1], color.green);
  pixel[2] = mix(pixel[2], color.blue);
}

void writePng(const Image& image, const std::filesystem::path& path) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  try {
    writePngTo(temporary, image);
    std::filesystem::rename(temporary, path);
  } catch (const std::filesystem::filesystem_error& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(path, error.code().message());
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

}  // namespace wells
