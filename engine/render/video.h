// MP4 video (H.264) from pictures, by the ffmpeg program at the other end of a pipe.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "render/image.h"

namespace wells {

class VideoWriter {
 public:
  /// Starts ffmpeg; an existing file is replaced. An odd width or height gets one more column or
  /// row of black, which the format needs. Throws std::runtime_error when there is no ffmpeg.
  VideoWriter(const std::filesystem::path& path, int width, int height, double framesPerSecond);

  /// Ends the file as close() does, but says nothing of errors.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Throws std::runtime_error with ffmpeg's own message when it has given up, and
  /// std::invalid_argument when the image has another size or the writer is closed.
  void write(const Image& image);

  /// Waits until the file is complete. Throws like write(). A second call does nothing.
  void close();

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  int finish();
  std::string whatItSaid();
  [[noreturn]] void fail();

  std::filesystem::path path_;
  int width_;
  int height_;
  int pipe_ = -1;                                   // ours of the two ends; -1: closed
  pid_t process_ = -1;                              // -1: ended
  std::unique_ptr<std::FILE, CloseFile> messages_;  // what ffmpeg says on its standard error
};

}  // namespace wells
