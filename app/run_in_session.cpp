#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "clocks.h"
#include "errors.h"
#include "interrupt.h"
#include "network/session.h"
#include "peer_runs.h"
#include "run_recorder.h"
#include "setting_checks.h"
#include "values.h"
#include "well_settings.h"
#include "world/measures.h"
#include "world_setup.h"

namespace wells {
namespace {

class SessionRun {
 public:
  SessionRun(PeerSetup& setup, Link& link, Pictures* pictures, RunProgress& progress,
             const std::function<void(const std::string&)>& notice)
      : setup_(setup),
        link_(link),
        pictures_(pictures),
        progress_(progress),
        recorder_(setup.options, pictures, progress),
        session_(makeSessionOptions(setup.options, setup.world, setup.motion, link, notice),
                 setup.world, *link.transport),
        timer_(stepRate(setup.options.config, setup.options.engine)),
        wellSettings_(setup.options.config) {
    if (setup.options.hasEnd()) session_.stopAt(setup.options.steps);
  }

  RunReport run() {
    while (!isOver()) {
      timer_.waitForNextTick();
      tick();
    }
    if (!ended_) end();
    session_.leave(setup_.world, readClocks());
    finishReport();
    return recorder_.report();
  }

 private:
  static constexpr double kMeasureInterval = 1;  // s of wall time, as often as statistics are sent

  void tick() {
    World& world = setup_.world;
    session_.beforeStep(world, readClocks());
    if (session_.phase() == Phase::Active && !begun_) begin();
    const int steps = session_.mayStep(world, readClocks());
    for (int i = 0; i < steps; ++i) {
      show(WhenBusy::Skip);
      setup_.stepper->step(world);
      session_.afterStep(world, readClocks());
      recorder_.stepped(world, *setup_.stepper);
    }
    if (steps == 0) session_.afterStep(world, readClocks());
    RunReport& report = recorder_.report();
    if (begun_) report.ballsOwnedMax = std::max(report.ballsOwnedMax, ballsOwnedHere());
    if (begun_ && !ended_ && session_.isComplete(world)) end();
    obeySettings();
    passOnMeasures();
  }

  /// Those that the session leaves to us.
  void obeySettings() {
    const std::int64_t step = setup_.world.step;
    const Register* rate = session_.settings().inForce(setting::kNetworkRate, step);
    if (rate && link_.lcm) link_.lcm->setTargetRate(parseNumber(rate->value));
    if (const double pace = session_.stepRate(setup_.world); pace != timer_.targetRate())
      timer_.setTargetRate(pace);
    wellSettings_.apply(session_.settings(), session_.peer(), step, setup_.motion);
  }

  void begin() {
    begun_ = true;
    recorder_.begin(setup_.world);
    progress_.joined = true;
  }

  // The run's results are those of the moment at which every ball has its owner's last state. The
  // session goes on for a while, so that the others get there too.
  void end() {
    const World& world = setup_.world;
    ended_ = readClocks().monotonic;
    show(WhenBusy::Wait);
    recorder_.end(world, *setup_.stepper);
    RunReport& report = recorder_.report();
    report.complete = session_.isComplete(world);
    report.peer = value(session_.peer());
    report.ballsOwned = ballsOwnedHere();
    const auto counts = session_.counts().balls;
    report.handoversGiven = counts.handoversGiven;
    report.handoversTaken = counts.handoversTaken;
    report.adoptions = counts.adoptions;
    for (const auto& [peer, balls] : session_.ballsOwned())
      report.owners[value(peer)] = static_cast<std::int64_t>(balls);
    for (const PeerId peer : session_.livingPeers(readClocks()))
      report.peers.push_back(value(peer));
  }

  bool isOver() {
    if (interrupted()) return true;
    const double now = readClocks().monotonic;
    const bool stopped = begun_ && setup_.world.step >= setup_.options.steps;
    if (!stopped) return false;
    if (!stoppedAt_) stoppedAt_ = now;
    // Who leaves gives up its balls, which would change the results of those that are not complete.
    const bool isDone = ended_ && session_.areOthersComplete(readClocks());
    return isDone || now >= *stoppedAt_ + 2 * setup_.options.config.lease;
  }

  void show(WhenBusy whenBusy) {
    const auto owners = [this] {
      std::vector<std::int32_t> ids;
      ids.reserve(session_.records().size());
      for (const Record& record : session_.records())
        ids.push_back(value(record.version.owner.peer));
      return ids;
    };
    recorder_.show(setup_.world, owners, whenBusy);
  }

  std::int64_t ballsOwnedHere() const {
    return static_cast<std::int64_t>(session_.ballsOwnedHere());
  }

  LoopRate networkRate(double LcmTransport::Rate::*which) const {
    if (!link_.lcm) return {};
    return {link_.lcm->targetRate(), link_.lcm->networkRate().*which};
  }

  void passOnMeasures() {
    const double now = readClocks().monotonic;
    if (!begun_ || now < nextMeasures_) return;
    nextMeasures_ = now + kMeasureInterval;
    std::vector<std::uint32_t> owned;
    for (std::uint32_t i = 0; i < setup_.world.balls.size(); ++i)
      if (setup_.world.owns(i)) owned.push_back(i);
    const Measures m = measure(setup_.world, owned);
    const LoopRate network = networkRate(&LcmTransport::Rate::recent);
    recorder_.setRates({timer_.targetRate(), timer_.recentRate()}, network);
    SessionMeasures measures{.simulationRate = timer_.recentRate(),
                             .simulationTarget = timer_.targetRate(),
                             .networkRate = network.actual,
                             .networkTarget = network.target,
                             .kineticEnergy = m.kineticEnergy,
                             .potentialEnergy = m.potentialEnergy,
                             .maxOverlap = m.worstOverlap()};
    if (pictures_) {
      measures.graphicsRate = pictures_->counts().recentRate;
      measures.graphicsTarget = pictures_->targetRate();
    }
    session_.setMeasures(measures);
  }

  void finishReport() {
    RunReport& report = recorder_.report();
    const SessionCounts counts = session_.counts();
    const TransportCounts sent = link_.transport->counts();
    const Generation& generation = session_.generation();
    report.wallTime = timer_.elapsed();
    report.simulation = {timer_.targetRate(), timer_.meanRate()};
    report.network = networkRate(&LcmTransport::Rate::mean);
    report.transport = link_.transport->description();
    report.generation = fmt::format("{}-{}-{:016x}", generation.resets, generation.foundedUs,
                                    static_cast<std::uint64_t>(generation.nonce));
    report.viewDifference = session_.viewDifference();
    report.messagesSent = sent.messagesSent;
    report.messagesReceived = counts.accepted;
    report.messagesDropped =
        counts.drops.total() + sent.droppedSending + sent.droppedReceiving + sent.droppedByKernel;
    report.droppedByKernel = sent.droppedByKernel;
    report.droppedInQueue = sent.droppedSending + sent.droppedReceiving;
    report.droppedByChecks = counts.drops.total();
    report.doubledBallSeconds = counts.balls.doubledBallSeconds;
    report.fences = counts.fences;
    report.resyncs = counts.resyncs;
    for (const auto& [reason, count] : counts.drops.faults())
      report.dropsByReason.emplace_back(name(reason), count);
    if (sent.droppedSending > 0) report.dropsByReason.emplace_back("not sent", sent.droppedSending);
    if (sent.droppedReceiving > 0)
      report.dropsByReason.emplace_back("receiving queue full", sent.droppedReceiving);
    report.bytesSent = sent.bytesSent;
    report.bytesReceived = sent.bytesReceived;
  }

  PeerSetup& setup_;
  Link& link_;
  Pictures* pictures_;
  RunProgress& progress_;
  RunRecorder recorder_;
  Session session_;
  StepTimer timer_;
  WellSettings wellSettings_;
  bool begun_ = false;               // part of the session, the world's steps count
  std::optional<double> stoppedAt_;  // s, when the last step was done
  std::optional<double> ended_;      // s, when the results were taken
  double nextMeasures_ = 0;          // s
};

}  // namespace

RunReport runInSession(PeerSetup& setup, Link& link, Pictures* pictures, RunProgress& progress,
                       const std::function<void(const std::string&)>& notice) {
  progress.joined = false;
  try {
    return SessionRun(setup, link, pictures, progress, notice).run();
  } catch (const PeerIdTaken& error) {
    throw UsageError(error.what());
  } catch (const WorldMismatch& error) {
    throw UsageError(error.what());
  }
}

}  // namespace wells
