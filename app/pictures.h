// The graphics thread: draws views into PNG files and a video. Frames are due in simulated time;
// frame k shows the world at k / GraphicsRate s.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "math/step_timer.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/video.h"
#include "render/view.h"

namespace wells {

struct PictureOptions {
  int width = 1024;             // pixels
  int height = 768;             // pixels
  double framesPerSecond = 30;  // of simulated time
  double targetRate = 0;        // frames in a wall second, Hz; 0: as they come
  Camera camera;
  std::vector<int> cores{};         // on which they are drawn; empty: any
  std::filesystem::path frames;     // a folder; empty: none
  std::filesystem::path video;      // empty: none
  std::filesystem::path lastFrame;  // empty: none
};

/// What show() does while the thread still has two views to draw.
enum class WhenBusy {
  Wait,
  Skip  // the frame before it is repeated in the files, and counted
};

class Pictures {
 public:
  /// Starts the thread. Throws RunError when OSMesa or ffmpeg is missing or a file cannot be made.
  explicit Pictures(const PictureOptions& options);
  ~Pictures();
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;

  /// True when the frame of `time` (s, simulated) was not shown yet.
  bool isDue(double time) const { return frameAt(time) > lastShown_; }

  /// Hands over what the frame of `time` shows. Throws what the thread failed with.
  void show(double time, View view, WhenBusy whenBusy);

  /// Waits until all is drawn and the files are complete; throws what the thread failed with.
  void close();

  struct Counts {
    std::int64_t drawn = 0;
    std::int64_t repeated = 0;  // frames in whose stead the one before stands
    double meanRate = 0;        // Hz, of drawn frames in wall time
    double recentRate = 0;      // Hz, over about the last second
  };
  Counts counts() const;

  double targetRate() const { return options_.targetRate; }  // Hz, in wall time; 0: none

 private:
  struct Job {
    std::int64_t frame;
    View view;
  };

  std::int64_t frameAt(double time) const;
  void run();
  std::optional<Job> nextJob();
  void drawUntilClosed();
  void write(std::int64_t frame, const Image& image);

  PictureOptions options_;
  std::unique_ptr<VideoWriter> video_;
  std::int64_t lastShown_ = -1;    // the caller's
  std::int64_t lastWritten_ = -1;  // the thread's
  StepTimer timer_;                // the thread's

  mutable std::mutex mutex_;  // guards the rest
  std::condition_variable changed_;
  std::optional<Job> next_;
  bool ready_ = false;
  bool closing_ = false;
  std::exception_ptr error_;
  Counts counts_;

  std::thread thread_;
};

}  // namespace wells
