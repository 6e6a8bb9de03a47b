#include "feature_peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "engines.h"
#include "errors.h"
#include "network/memory_transport.h"
#include "network/session.h"
#include "pictures.h"
#include "predictors.h"
#include "run_recorder.h"
#include "state/stepper.h"
#include "views.h"
#include "world/measures.h"

namespace wells {
namespace {

constexpr double kLease = 0.5;       // s: who joins listens for two
constexpr double kLongestJoin = 10;  // s, simulated

struct RecordedWorld {
  RecordedWorld(World start, std::unique_ptr<Pictures> watching)
      : world(std::move(start)),
        stepper(makeEngine("ours")),
        pictures(std::move(watching)),
        recorder(options, pictures.get(), progress) {
    options.quiet = true;
    recorder.begin(world);
  }

  void step() {
    recorder.setRates({}, {});
    recorder.show(
        world, [this] { return std::vector<std::int32_t>(world.balls.size(), 1); }, WhenBusy::Wait);
    stepper->step(world);
    recorder.stepped(world, *stepper);
  }

  PeerOptions options;
  RunProgress progress;
  World world;
  std::unique_ptr<Stepper> stepper;
  std::unique_ptr<Pictures> pictures;
  RunRecorder recorder;
};

struct MemoryPeer {
  MemoryPeer(int id, const World& start, const std::shared_ptr<MemoryNetwork>& network)
      : world(start),
        stepper(makeEngine("ours")),
        transport(network),
        session(optionsOf(id), world, transport) {}

  static SessionOptions optionsOf(int id) {
    SessionOptions options;
    options.peer = PeerId{id};
    options.seed = static_cast<std::uint64_t>(id);
    options.lease = kLease;
    options.well.at = [](PeerId, std::int64_t step) { return WellKeyframe{step, {}, 0}; };
    options.predict = makePredictor("ours");
    return options;
  }

  void tick(Times now) {
    session.beforeStep(world, now);
    const int steps = session.mayStep(world, now);
    for (int i = 0; i < steps; ++i) {
      stepper->step(world);
      session.afterStep(world, now);
    }
    if (steps == 0) session.afterStep(world, now);
  }

  World world;
  std::unique_ptr<Stepper> stepper;
  MemoryTransport transport;
  Session session;
};

struct MemoryGroup {
  MemoryGroup(const World& start, int count) : dt(start.settings.dt) {
    for (int id = 1; id <= count; ++id)
      peers.push_back(std::make_unique<MemoryPeer>(id, start, network));
    const auto isActive = [](const auto& peer) { return peer->session.phase() == Phase::Active; };
    while (!std::ranges::all_of(peers, isActive)) {
      if (network->now() > kLongestJoin)
        throw RunError(fmt::format("a session in memory was not joined within {} s", kLongestJoin));
      others();
      peers.front()->tick(now());
    }
  }

  Times now() const { return {network->now(), static_cast<std::int64_t>(1e6 * network->now())}; }

  void others() {
    network->advance(dt);
    for (std::size_t i = 1; i < peers.size(); ++i) peers[i]->tick(now());
  }

  double dt;  // s
  std::shared_ptr<MemoryNetwork> network = std::make_shared<MemoryNetwork>();
  std::vector<std::unique_ptr<MemoryPeer>> peers;
};

}  // namespace

FeatureRun recordedRun(World start, Recording recording) {
  const auto run = std::make_shared<RecordedWorld>(std::move(start), nullptr);
  if (recording == Recording::None) return {.step = [run] { run->step(); }};
  run->stepper->openBooks();
  return {.step = [run] {
    run->step();
    measure(run->world);
  }};
}

FeatureRun watchedRun(World start, double framesPerSecond, const std::filesystem::path& folder) {
  PictureOptions options;
  options.framesPerSecond = framesPerSecond;
  options.camera = makeCamera({});
  options.lastFrame = folder / "features.png";
  const auto run =
      std::make_shared<RecordedWorld>(std::move(start), std::make_unique<Pictures>(options));
  return {.step = [run] { run->step(); }};
}

FeatureRun sessionRun(const World& start, int peers) {
  const auto run = std::make_shared<MemoryGroup>(start, peers);
  return {.step = [run] { run->peers.front()->tick(run->now()); },
          .meanwhile = [run] { run->others(); }};
}

}  // namespace wells
