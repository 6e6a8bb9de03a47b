// One line on a terminal that says how far a run is. RunProgress is written by the simulation
// thread and shown by the main thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

namespace wells {

struct RunProgress {
  std::atomic<std::int64_t> firstStep = 0;  // of this run; a session may be older
  std::atomic<std::int64_t> step = 0;
  std::atomic<bool> joined = true;  // false: waits to be part of the session
};

/// Where a run stops, and how its steps are counted in time.
struct RunGoal {
  std::int64_t steps = 0;
  double dt = 0;  // s
  bool hasEnd = false;
};

/// A line on stderr that each text overwrites; nothing where stderr is no terminal.
class StatusLine {
 public:
  StatusLine();

  /// Clears the line.
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(const std::string& text) const;

 private:
  bool isShown_;
};

class ProgressLine {
 public:
  enum class Shown { Yes, No };

  ProgressLine(const RunGoal& goal, Shown shown);

  /// `wallTime` in s since the first step of the run.
  void show(const RunProgress& progress, double wallTime) const;

 private:
  RunGoal goal_;
  std::optional<StatusLine> line_;
};

/// "t = 3.20 of 10.00 s, 61 steps/s, 7 s left". The steps since `firstStep` took `wallTime` s.
std::string progressText(const RunGoal& goal, std::int64_t firstStep, std::int64_t step,
                         double wallTime);

/// A line of its own on stderr, where the line of progress may stand.
void printNotice(const std::string& text);

}  // namespace wells
