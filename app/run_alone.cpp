#include <fmt/format.h>

#include <span>
#include <vector>

#include "engines.h"
#include "errors.h"
#include "forces/field.h"
#include "interrupt.h"
#include "peer_runs.h"
#include "run_recorder.h"
#include "saved_config.h"
#include "snapshot_file.h"
#include "world_setup.h"

namespace wells {
namespace {

World worldOf(const PeerOptions& options) {
  return options.restored ? options.restored->world : makeWorld(options.config, options.engine);
}

bool isSaveDue(const PeerOptions& options, std::int64_t step) {
  return options.snapshotEvery > 0 && step % options.snapshotEvery == 0;
}

/// Wells so sharp that a step could not be divided finely enough to resolve them.
void requireResolvable(std::span<const WellTrack> tracks, double dt) {
  for (const WellTrack& track : tracks)
    for (const WellKeyframe& key : track.keyframes) {
      const double stretches = stretchesWanted(key.strength, track.softening, dt);
      if (stretches <= kMostStretches) continue;
      throw UsageError(
          fmt::format("a well of strength {} m^3/s^2 with softening {} m: flight past it takes "
                      "{:.0f} stretches "
                      "in a step of {:.6g} s; allowed: up to {}, so a larger softening, a smaller "
                      "strength or a "
                      "shorter Dt",
                      key.strength, track.softening, stretches, dt, kMostStretches));
    }
}

}  // namespace

PeerSetup::PeerSetup(const PeerOptions& peerOptions)
    : options(peerOptions),
      world(worldOf(options)),
      motion(options.config, world.settings.dt),
      stepper(makeEngine(options.engine, Sleeping::Off, options.places.simulationThreads)) {
  if (!options.snapshot.empty() && !stepper->memory()) {
    throw UsageError(
        fmt::format("--save-snapshot: engine {} keeps what cannot be saved; allowed: ours and the "
                    "reference engines",
                    options.engine));
  }
  if (options.restored) stepper->restore(options.restored->memory);
  if (options.measures && !stepper->openBooks())
    throw UsageError(
        fmt::format("--measures: engine {} keeps no books; allowed: ours", options.engine));
  if (options.engine != "ours") return;
  requireResolvable(world.tracks, world.settings.dt);
  const WellTrack own = motion.trackAt(PeerId{1}, world.step);
  requireResolvable({&own, 1}, world.settings.dt);
}

void PeerSetup::saveSnapshot() const {
  writeSnapshot(options.snapshot,
                {world, *stepper->memory(), stepper->name(), savedConfig(options.config)});
}

RunReport runAlone(PeerSetup& setup, Pictures* pictures, RunProgress& progress) {
  const PeerOptions& options = setup.options;
  World& world = setup.world;
  const auto self = static_cast<std::int32_t>(options.config.peerId);
  if (!options.restored) world.tracks.push_back(setup.motion.trackAt(PeerId{self}, world.step));
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
    if (isSaveDue(options, world.step)) setup.saveSnapshot();
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
