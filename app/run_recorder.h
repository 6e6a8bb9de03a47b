// Watches a run: hands due frames to the graphics thread, takes measures, and fills in the part of
// the report that is the same alone and in a session.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "peer_options.h"
#include "pictures.h"
#include "progress.h"
#include "run_report.h"
#include "state/stepper.h"
#include "views.h"

namespace wells {

class RunRecorder {
 public:
  using Owners = std::function<std::vector<std::int32_t>()>;

  /// `pictures` may be nullptr: nobody watches.
  RunRecorder(const PeerOptions& options, Pictures* pictures, RunProgress& progress);

  /// The world before the first step.
  void begin(const World& world);

  /// The world at the start of a step, or at the end: shows it if a frame is due. `owners` is asked
  /// only then.
  void show(const World& world, const Owners& owners, WhenBusy whenBusy);

  /// After a step.
  void stepped(const World& world, const Stepper& stepper);

  /// The world after the last step. Loops' rates are the caller's to fill in.
  void end(const World& world, const Stepper& stepper);

  /// What frames say of the loops.
  void setRates(const LoopRate& simulation, const LoopRate& network);

  RunReport& report() { return report_; }

 private:
  bool measures() const { return !options_.report.empty() || !options_.quiet; }
  void sample(const World& world);

  const PeerOptions& options_;
  Pictures* pictures_;
  RunProgress& progress_;
  ViewNotes notes_;
  RunReport report_;
  std::int64_t sampledSecond_ = 0;  // of simulated time
};

}  // namespace wells
