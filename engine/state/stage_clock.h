// Where the time of a step goes: each instant of it belongs to one stage, so that the times of all
// stages add up to the step's. For reports; nothing of it changes the state. Who has no clock (a
// null pointer) pays for a comparison.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace wells {

/// The parts of a step, as they are reported. The thread that calls step() counts: what others do
/// meanwhile is the stage that it waits in.
enum class Stage : std::uint8_t {
  Sleep,       // who sleeps, who wakes, who falls asleep
  Candidates,  // broadphase, gaps, sorted pairs
  Islands,     // what hangs together, and which method moves it
  Exact,       // impacts at their own times, rolling and sliding of single balls
  Flight,      // of balls that touch nothing, and of the others within substeps
  Batches,     // crowds: small records of balls, batches of contacts that share none
  Prepare,     // contacts of substeps: gaps, normals, masses, impulses to start from
  Solve,       // impulses of substeps
  Push,        // positions: shifts by forces of contact, push-out of overlap
  Books,       // energy and momentum by source
  Other
};

inline constexpr std::array<std::string_view, 11> kStageNames = {
    "sleep",   "candidates", "islands", "exact", "flight", "batches",
    "prepare", "solve",      "push",    "books", "other"};

constexpr std::string_view name(Stage stage) {
  return kStageNames.at(static_cast<std::size_t>(stage));
}

using StageTimes = std::array<double, kStageNames.size()>;  // s, by Stage

class StageClock {
 public:
  /// A step begins, in Stage::Other. It ends with the outermost StageScope.
  void begin() {
    times_ = {};
    stage_ = Stage::Other;
    since_ = Clock::now();
  }

  /// The time until the next call belongs to `next`. Returns the stage that ends.
  Stage enter(Stage next) {
    const Clock::time_point now = Clock::now();
    times_[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    const Stage before = stage_;
    stage_ = next;
    return before;
  }

  /// Since the last begin(), but for the stage that lasts.
  const StageTimes& times() const { return times_; }

 private:
  using Clock = std::chrono::steady_clock;

  StageTimes times_{};
  Stage stage_ = Stage::Other;
  Clock::time_point since_;
};

/// A stage for as long as this lives; then the one before goes on. `clock` may be null.
class StageScope {
 public:
  StageScope(StageClock* clock, Stage stage) : clock_(clock) {
    if (clock_) before_ = clock_->enter(stage);
  }
  ~StageScope() { next(before_); }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

  /// Another one from here on.
  void next(Stage stage) {
    if (clock_) clock_->enter(stage);
  }

 private:
  StageClock* clock_;
  Stage before_ = Stage::Other;
};

}  // namespace wells
