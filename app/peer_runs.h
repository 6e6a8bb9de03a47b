// The two ways to run a peer: alone, or in a session with others. Both are the simulation thread's
// loop; they return when the run's end has come or an interrupt.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "peer_options.h"
#include "pictures.h"
#include "progress.h"
#include "run_report.h"
#include "session_setup.h"
#include "state/stepper.h"
#include "well_motion.h"

namespace wells {

/// What both start from. Making it finds every error in the config's files.
struct PeerSetup {
  explicit PeerSetup(const PeerOptions& peerOptions);

  const PeerOptions& options;
  World world;                       // at step 0, without this peer's well; or as restored, with it
  WellMotion motion;                 // of this peer's well
  std::unique_ptr<Stepper> stepper;  // the engine

  /// Writes the file of --save-snapshot. Throws RunError.
  void saveSnapshot() const;
};

/// Alone: this peer owns all balls. As fast as possible unless SimulationRate says otherwise; waits
/// for the pictures (nullptr: none).
RunReport runAlone(PeerSetup& setup, Pictures* pictures, RunProgress& progress);

/// In a session over `link`, in wall time. At the end it waits, for two leases at most, until every
/// ball has its owner's last state. `notice` gets what the user should know. Throws UsageError when
/// the group simulates another world, or somebody has the id that the user insists on.
RunReport runInSession(PeerSetup& setup, Link& link, Pictures* pictures, RunProgress& progress,
                       const std::function<void(const std::string&)>& notice);

}  // namespace wells
