#include "render/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <fstream>

#include "render/temporary_folder.h"

namespace wells {
namespace {

Image gradient(int width, int height) {
  Image image = makeImage(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = pixelAt(image, x, y);
      pixel[0] = static_cast<std::uint8_t>(7 * x);
      pixel[1] = static_cast<std::uint8_t>(5 * y);
      pixel[2] = static_cast<std::uint8_t>(x * y);
    }
  }
  return image;
}

TEST(Png, ReadsBackAsWritten) {
  const TemporaryFolder folder;
  const Image written = gradient(37, 23);
  writePng(written, folder / "picture.png");

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, (folder / "picture.png").c_str()), 0);
  EXPECT_EQ(png.width, 37u);
  EXPECT_EQ(png.height, 23u);
  png.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, written.rgb);
}

TEST(Png, LeavesNoOtherFileBehind) {
  const TemporaryFolder folder;
  writePng(gradient(4, 4), folder / "picture.png");
  writePng(gradient(5, 5), folder / "picture.png");
  const std::filesystem::directory_iterator files(folder / "");
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(Png, NamesThePathThatItCannotWrite) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "missing/picture.png";
  try {
    writePng(gradient(4, 4), path);
    FAIL() << "wrote into a missing folder";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST(Png, KeepsTheOldFileWhenTheNewOneFails) {
  const TemporaryFolder folder;
  const std::filesystem::path occupied = folder / "folder";
  std::filesystem::create_directories(occupied / "inside");
  EXPECT_THROW(writePng(gradient(4, 4), occupied), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_directory(occupied / "inside"));
  EXPECT_FALSE(std::filesystem::exists(folder / "folder.part"));
}

TEST(Image, BlendsInsideAndIgnoresOutside) {
  Image image = makeImage(2, 2);
  blendPixel(image, 1, 0, {200, 100, 50}, 0.5);
  blendPixel(image, 2, 0, {255, 255, 255}, 1);
  blendPixel(image, 0, -1, {255, 255, 255}, 1);
  EXPECT_EQ(colorAt(image, 1, 0), (Color{100, 50, 25}));
  EXPECT_EQ(colorAt(image, 0, 1), (Color{0, 0, 0}));
}

}  // namespace
}  // namespace wells
