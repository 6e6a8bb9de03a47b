#include "pictures.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "errors.h"
#include "progress.h"
#include "temporary_folder.h"

namespace wells {
namespace {

PictureOptions smallPictures(const TemporaryFolder& folder) {
  PictureOptions options;
  options.width = 64;
  options.height = 64;
  options.framesPerSecond = 10;
  options.frames = folder / "frames";
  options.lastFrame = folder / "last.png";
  return options;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

View ballAt(double x) {
  View view;
  view.position = {Vec3{x, 1, 0}};
  view.radius = {5};
  return view;
}

TEST(Pictures, DrawEachFrameOnceInSimulatedTime) {
  const TemporaryFolder folder;
  Pictures pictures(smallPictures(folder));
  const double dt = 1.0 / 60;
  for (int step = 0; step <= 60; ++step)
    if (pictures.isDue(step * dt)) pictures.show(step * dt, ballAt(step), WhenBusy::Wait);
  pictures.close();
  EXPECT_EQ(pictures.counts().drawn, 11);
  EXPECT_EQ(pictures.counts().repeated, 0);
  EXPECT_EQ(content(folder / "last.png"), content(folder / "frames" / "frame_000010.png"));
}

TEST(Pictures, RepeatTheFrameBeforeForTheMissingOnes) {
  const TemporaryFolder folder;
  Pictures pictures(smallPictures(folder));
  pictures.show(0, ballAt(-10), WhenBusy::Wait);
  pictures.show(0.3, ballAt(10), WhenBusy::Wait);  // frames 1 and 2 never came
  pictures.close();
  EXPECT_EQ(pictures.counts().drawn, 2);
  EXPECT_EQ(pictures.counts().repeated, 2);
  const auto frame = [&](int k) {
    return content(folder / "frames" / ("frame_00000" + std::to_string(k) + ".png"));
  };
  EXPECT_EQ(frame(1), frame(0));
  EXPECT_EQ(frame(2), frame(0));
  EXPECT_NE(frame(3), frame(0));
}

TEST(Pictures, BeginWithTheFirstFrameThatIsShown) {
  const TemporaryFolder folder;
  Pictures pictures(smallPictures(folder));
  pictures.show(100, ballAt(0), WhenBusy::Wait);  // a peer that joins a session late
  pictures.close();
  EXPECT_EQ(pictures.counts().repeated, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "frames" / "frame_001000.png"));
}

// Handed over faster than any drawing: some are skipped, none is waited for, none is missing.
TEST(Pictures, SkipWhenBusyAndMakeUpForIt) {
  const TemporaryFolder folder;
  Pictures pictures(smallPictures(folder));
  for (int k = 0; k < 50; ++k) pictures.show(0.1 * k, ballAt(k), WhenBusy::Skip);
  pictures.show(5, ballAt(50), WhenBusy::Wait);
  pictures.close();
  const Pictures::Counts counts = pictures.counts();
  EXPECT_GE(counts.drawn, 2);
  EXPECT_EQ(counts.drawn + counts.repeated, 51);
}

TEST(Pictures, PassOnWhatTheThreadFailedWith) {
  const TemporaryFolder folder;
  PictureOptions options = smallPictures(folder);
  Pictures pictures(options);
  std::filesystem::remove_all(options.frames);
  pictures.show(0, ballAt(0), WhenBusy::Wait);
  EXPECT_THROW(pictures.close(), RunError);
}

TEST(Progress, TellsTheTimeLeft) {
  const RunGoal goal{.steps = 600, .dt = 1.0 / 60, .hasEnd = true};
  EXPECT_EQ(progressText(goal, 0, 150, 3), "t = 2.50 of 10.00 s, 50 steps/s, 9 s left");
  EXPECT_EQ(progressText(goal, 0, 0, 0), "t = 0.00 of 10.00 s, 0 steps/s");
  EXPECT_EQ(progressText(goal, 0, 600, 12), "t = 10.00 of 10.00 s, finishing");
  EXPECT_EQ(progressText({.steps = 0, .dt = 0.5, .hasEnd = false}, 0, 10, 2),
            "t = 5.00 s, 5 steps/s; Ctrl-C ends");
}

TEST(Progress, OfALateJoinerCountsItsOwnSteps) {
  const RunGoal goal{.steps = 600, .dt = 1.0 / 60, .hasEnd = true};
  EXPECT_EQ(progressText(goal, 300, 450, 3), "t = 7.50 of 10.00 s, 50 steps/s, 3 s left");
}

}  // namespace
}  // namespace wells
