#include "render/video.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>

#include "render/temporary_folder.h"

namespace wells {
namespace {

Image plain(int width, int height, std::uint8_t grey) {
  Image image = makeImage(width, height);
  std::fill(image.rgb.begin(), image.rgb.end(), grey);
  return image;
}

/// Compresses badly, so that a few of them fill some kilobytes.
Image striped(int width, int height, int phase) {
  Image image = makeImage(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>((i * i) >> (phase % 8));
  return image;
}

/// What ffprobe counts when it decodes every frame: "width,height,frame rate,frames".
std::string probe(const std::filesystem::path& path) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -of csv=p=0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames '" +
      path.string() + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run ffprobe");
  char line[200] = "";
  if (std::fgets(line, sizeof line, pipe) == nullptr) line[0] = '\0';
  pclose(pipe);
  std::string text = line;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Video, HasTheFramesThatWereWritten) {
  const TemporaryFolder folder;
  VideoWriter video(folder / "a video.mp4", 64, 48, 30);
  for (int i = 0; i < 17; ++i) video.write(plain(64, 48, static_cast<std::uint8_t>(10 * i)));
  video.close();
  video.close();
  EXPECT_EQ(probe(folder / "a video.mp4"), "64,48,30/1,17");
}

TEST(Video, OddSizesGetOneMoreRowAndColumn) {
  const TemporaryFolder folder;
  VideoWriter video(folder / "odd.mp4", 63, 47, 12.5);
  for (int i = 0; i < 5; ++i) video.write(plain(63, 47, 100));
  video.close();
  EXPECT_EQ(probe(folder / "odd.mp4"), "64,48,25/2,5");
}

TEST(Video, DestructorCompletesTheFile) {
  const TemporaryFolder folder;
  {
    VideoWriter video(folder / "video.mp4", 64, 48, 10);
    video.write(plain(64, 48, 9));
  }
  EXPECT_EQ(probe(folder / "video.mp4"), "64,48,10/1,1");
}

// SIGPIPE has its default action here, which would end the test.
TEST(Video, ReportsWhatFfmpegSaysAndSurvivesItsDeath) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "missing/video.mp4";
  const std::string message = messageOf([&] {
    VideoWriter video(path, 640, 480, 30);
    for (int i = 0; i < 50; ++i) video.write(plain(640, 480, 50));
    video.close();
  });
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

// A limit on the size of files stands for a full disk: ffmpeg cannot complete the video, and yet
// its exit status is 0.
TEST(Video, ReportsAnIncompleteFile) {
  const TemporaryFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};  // bytes
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = messageOf([&] {
    VideoWriter limited(folder / "limited.mp4", 640, 480, 30);
    for (int i = 0; i < 10; ++i) limited.write(striped(640, 480, i));
    limited.close();
  });
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_DFL);
  EXPECT_NE(message.find("limited.mp4: ffmpeg says: "), std::string::npos) << message;
}

TEST(Video, SaysWhenThereIsNoFfmpeg) {
  const TemporaryFolder folder;
  const std::string path = getenv("PATH");
  setenv("PATH", (folder / "").c_str(), 1);
  const std::string message = messageOf([&] { VideoWriter video(folder / "v.mp4", 64, 48, 30); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(message.find("ffmpeg is not installed"), std::string::npos) << message;
}

TEST(Video, RefusesPicturesOfAnotherSizeAndWritesAfterClose) {
  const TemporaryFolder folder;
  VideoWriter video(folder / "video.mp4", 64, 48, 30);
  EXPECT_THROW(video.write(plain(48, 64, 0)), std::invalid_argument);
  video.write(plain(64, 48, 0));
  video.close();
  EXPECT_THROW(video.write(plain(64, 48, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace wells
