#include "render/video.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

extern char** environ;

namespace wells {
namespace {

std::runtime_error videoError(const std::filesystem::path& path, const std::string& reason) {
  return std::runtime_error("cannot write the video " + path.string() + ": " + reason);
}

/// Starts ffmpeg with the given standard input and error; returns 0 or the error's number.
int start(const std::vector<std::string>& arguments, int input, int messages, pid_t& process) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);

  // A process group of its own: Ctrl-C is for us, who then end the video in good order. And our
  // thread's blocked signals are no business of ffmpeg's.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);

  const int error = posix_spawnp(&process, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height,
                         double framesPerSecond)
    : path_(path), width_(width), height_(height), messages_(std::tmpfile()) {
  if (!messages_) throw videoError(path, std::strerror(errno));
  fcntl(fileno(messages_.get()), F_SETFD, FD_CLOEXEC);

  // A socket pair instead of a pipe: send() can be told not to raise SIGPIPE when ffmpeg has died.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw videoError(path, std::strerror(errno));
  }
  const std::vector<std::string> arguments = {"ffmpeg",
                                              "-hide_banner",
                                              "-loglevel",
                                              "error",
                                              "-nostdin",
                                              "-y",
                                              "-f",
                                              "rawvideo",
                                              "-pixel_format",
                                              "rgb24",
                                              "-video_size",
                                              std::to_string(width) + "x" + std::to_string(height),
                                              "-framerate",
                                              std::to_string(framesPerSecond),
                                              "-i",
                                              "pipe:0",
                                              "-vf",
                                              "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                              "-c:v",
                                              "libx264",
                                              "-preset",
                                              "veryfast",
                                              "-crf",
                                              "20",
                                              "-pix_fmt",
                                              "yuv420p",
                                              "-movflags",
                                              "+faststart",
                                              "-f",
                                              "mp4",
                                              "file:" + path.string()};
  const int error = start(arguments, ends[1], fileno(messages_.get()), process_);
  ::close(ends[1]);
  pipe_ = ends[0];
  if (error != 0) {
    ::close(pipe_);
    throw videoError(path, error == ENOENT
                               ? "the program ffmpeg is not installed (Debian's package ffmpeg)"
                               : std::string("ffmpeg does not start: ") + std::strerror(error));
  }
}

VideoWriter::~VideoWriter() {
  finish();
}

void VideoWriter::write(const Image& image) {
  if (pipe_ < 0) throw std::invalid_argument("the video " + path_.string() + " is closed");
  if (image.width != width_ || image.height != height_) {
    throw std::invalid_argument("a picture of " + std::to_string(image.width) + " x " +
                                std::to_string(image.height) + " pixels in a video of " +
                                std::to_string(width_) + " x " + std::to_string(height_));
  }
  std::size_t sent = 0;
  while (sent < image.rgb.size()) {
    const ssize_t count =
        send(pipe_, image.rgb.data() + sent, image.rgb.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      finish();
      fail();
    }
    sent += static_cast<std::size_t>(count);
  }
}

void VideoWriter::close() {
  if (pipe_ < 0) return;
  // ffmpeg's exit status is 0 even when the disk was full, but it does not keep silent about that.
  if (finish() != 0 || !whatItSaid().empty()) fail();
}

int VideoWriter::finish() {
  if (pipe_ < 0) return 0;
  ::close(pipe_);
  pipe_ = -1;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

std::string VideoWriter::whatItSaid() {
  std::string text(2000, '\0');
  std::rewind(messages_.get());
  text.resize(std::fread(text.data(), 1, text.size(), messages_.get()));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void VideoWriter::fail() {
  const std::string text = whatItSaid();
  throw videoError(path_, text.empty() ? "ffmpeg has ended" : "ffmpeg says: " + text);
}

}  // namespace wells
