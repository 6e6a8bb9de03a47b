#include "pictures.h"

#include <fmt/format.h>

#include <cmath>

#include "errors.h"
#include "render/renderer.h"
#include "thread_places.h"

namespace wells {
namespace {

std::filesystem::path framePath(const std::filesystem::path& folder, std::int64_t frame) {
  return folder / fmt::format("frame_{:06}.png", frame);
}

}  // namespace

Pictures::Pictures(const PictureOptions& options) : options_(options), timer_(options.targetRate) {
  try {
    if (!options_.frames.empty()) std::filesystem::create_directories(options_.frames);
    if (!options_.video.empty()) {
      video_ = std::make_unique<VideoWriter>(options_.video, options_.width, options_.height,
                                             options_.framesPerSecond);
    }
  } catch (const std::runtime_error& error) {
    throw RunError(error.what());
  }
  thread_ = std::thread([this] { run(); });
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return ready_ || error_; });
  if (!error_) return;
  lock.unlock();
  thread_.join();
  std::rethrow_exception(error_);
}

Pictures::~Pictures() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::int64_t Pictures::frameAt(double time) const {
  constexpr double kRounding = 1e-6;  // of a frame: time is a sum of steps that need not be exact
  return static_cast<std::int64_t>(std::floor(time * options_.framesPerSecond + kRounding));
}

void Pictures::show(double time, View view, WhenBusy whenBusy) {
  lastShown_ = frameAt(time);
  std::unique_lock lock(mutex_);
  if (whenBusy == WhenBusy::Wait) changed_.wait(lock, [this] { return !next_ || error_; });
  if (error_) std::rethrow_exception(error_);
  if (next_) return;
  next_ = Job{lastShown_, std::move(view)};
  lock.unlock();
  changed_.notify_all();
}

void Pictures::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  if (error_) std::rethrow_exception(error_);
}

Pictures::Counts Pictures::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void Pictures::run() {
  try {
    placeThisThread("graphics", options_.cores);
    drawUntilClosed();
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    error_ = std::make_exception_ptr(RunError(fmt::format("pictures: {}", error.what())));
  }
  changed_.notify_all();
}

std::optional<Pictures::Job> Pictures::nextJob() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return next_ || closing_; });
  std::optional<Job> job = std::move(next_);
  next_.reset();
  lock.unlock();
  changed_.notify_all();
  return job;
}

void Pictures::drawUntilClosed() {
  Renderer renderer(options_.width, options_.height);
  {
    const std::lock_guard lock(mutex_);
    ready_ = true;
  }
  changed_.notify_all();
  Image image;
  Image before;
  while (std::optional<Job> job = nextJob()) {
    timer_.waitForNextTick();
    renderer.draw(job->view, options_.camera, image);
    const std::int64_t missing = lastWritten_ < 0 ? 0 : job->frame - lastWritten_ - 1;
    for (std::int64_t i = 0; i < missing; ++i) write(lastWritten_ + 1, before);
    if (lastWritten_ < 0) lastWritten_ = job->frame - 1;  // a peer that joins late
    write(job->frame, image);
    std::swap(image, before);
    const std::lock_guard lock(mutex_);
    ++counts_.drawn;
    counts_.repeated += missing;
    counts_.meanRate = timer_.meanRate();
    counts_.recentRate = timer_.recentRate();
  }
  if (video_) video_->close();
  if (!options_.lastFrame.empty() && lastWritten_ >= 0) writePng(before, options_.lastFrame);
}

void Pictures::write(std::int64_t frame, const Image& image) {
  if (!options_.frames.empty()) writePng(image, framePath(options_.frames, frame));
  if (video_) video_->write(image);
  lastWritten_ = frame;
}

}  // namespace wells
