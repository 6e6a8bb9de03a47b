#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace wells {
namespace {

constexpr const char* kClearLine = "\r\033[K";

bool isOnTerminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

}  // namespace

std::string progressText(const RunGoal& goal, std::int64_t firstStep, std::int64_t step,
                         double wallTime) {
  const double done = static_cast<double>(step);
  const double rate = wallTime > 0 ? static_cast<double>(step - firstStep) / wallTime : 0;
  if (!goal.hasEnd)
    return fmt::format("t = {:.2f} s, {:.0f} steps/s; Ctrl-C ends", done * goal.dt, rate);
  const double all = static_cast<double>(goal.steps);
  if (done >= all)
    return fmt::format("t = {:.2f} of {:.2f} s, finishing", done * goal.dt, all * goal.dt);
  const std::string left =
      rate > 0 ? fmt::format(", {:.0f} s left", (all - done) / rate) : std::string();
  return fmt::format("t = {:.2f} of {:.2f} s, {:.0f} steps/s{}", done * goal.dt, all * goal.dt,
                     rate, left);
}

StatusLine::StatusLine() : isShown_(isOnTerminal()) {}

StatusLine::~StatusLine() {
  if (isShown_) fmt::print(stderr, "{}", kClearLine);
}

void StatusLine::show(const std::string& text) const {
  if (!isShown_) return;
  fmt::print(stderr, "{}{}", kClearLine, text);
  std::fflush(stderr);
}

ProgressLine::ProgressLine(const RunGoal& goal, Shown shown) : goal_(goal) {
  if (shown == Shown::Yes) line_.emplace();
}

void ProgressLine::show(const RunProgress& progress, double wallTime) const {
  if (!line_) return;
  line_->show(progress.joined ? progressText(goal_, progress.firstStep, progress.step, wallTime)
                              : "listening for other peers");
}

void printNotice(const std::string& text) {
  fmt::print(stderr, "{}{}\n", isOnTerminal() ? kClearLine : "", text);
}

}  // namespace wells
