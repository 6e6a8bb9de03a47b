#include <vector>

#include "engines.h"
#include "interrupt.h"
#include "peer_runs.h"
#include "run_recorder.h"
#include "world_setup.h"

namespace wells {

PeerSetup::PeerSetup(const PeerOptions& peerOptions)
    : options(peerOptions),
      world(makeWorld(options.config, options.engine)),
      motion(options.config, world.settings.dt),
      stepper(makeEngine(options.engine)) {}

RunReport runAlone(PeerSetup& setup, Pictures* pictures, RunProgress& progress) {
  const PeerOptions& options = setup.options;
  World& world = setup.world;
  const auto self = static_cast<std::int32_t>(options.config.peerId);
  world.tracks.push_back(setup.motion.trackAt(PeerId{self}, world.step));
  const auto owners = [&] { return std::vector<std::int32_t>(world.balls.size(), self); };

  StepTimer timer(options.config.simulationRate > 0 ? stepRate(options.config, options.engine) : 0);
  RunRecorder recorder(options, pictures, progress);
  recorder.begin(world);
  while (world.step < options.steps && !interrupted()) {
    timer.waitForNextTick();
    setup.motion.extend(world.tracks.back(), world.step);
    recorder.setRates({timer.targetRate(), timer.recentRate()}, {});
    recorder.show(world, owners, WhenBusy::Wait);
    setup.stepper->step(world);
    recorder.stepped(world, *setup.stepper);
  }
  setup.motion.extend(world.tracks.back(), world.step);
  recorder.show(world, owners, WhenBusy::Wait);
  recorder.end(world, *setup.stepper);

  RunReport report = recorder.report();
  report.wallTime = timer.elapsed();
  report.simulation = {timer.targetRate(), timer.meanRate()};
  report.peers = {self};
  report.ballsOwned = report.ballsOwnedMax = static_cast<std::int64_t>(world.balls.size());
  report.owners = {{self, report.ballsOwned}};
  return report;
}

}  // namespace wells
