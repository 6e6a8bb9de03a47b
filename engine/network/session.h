// A peer's half of the protocol: finds the others without a server, shares the balls with them by
// ownership records, moves the wells by keyframes and keeps pace. One thread, no clock: the
// simulation loop drives it and passes the time in.
//
//   Session session(options, world, transport);
//   loop:
//     session.beforeStep(world, now);
//     const int steps = session.mayStep(world, now);
//     for (int i = 0; i < steps; ++i) { stepper.step(world); session.afterStep(world, now); }
//     if (steps == 0) session.afterStep(world, now);
//   session.leave(world, now);
//
// It throws PeerIdTaken and WorldMismatch (session_options.h) from beforeStep().
#pragma once

#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/random.h"
#include "network/codec.h"
#include "network/pace.h"
#include "network/peers.h"
#include "network/session_options.h"
#include "network/shared_balls.h"
#include "network/shared_settings.h"
#include "network/state_schedule.h"

namespace wells {

/// What the application measures for the others to see (statistics_t); the session only passes it
/// on.
struct SessionMeasures {
  double simulationRate = 0, simulationTarget = 0;  // Hz
  double networkRate = 0, networkTarget = 0;        // Hz
  double graphicsRate = 0, graphicsTarget = 0;      // Hz
  double kineticEnergy = 0, potentialEnergy = 0;    // J, of the owned balls
  double maxOverlap = 0;                            // m, of the owned balls
};

/// Since the start.
struct SessionCounts {
  BallCounts balls;
  std::int64_t accepted = 0;  // messages that passed all checks
  DropCounts drops;           // messages that did not
  std::int64_t fences = 0;    // times that our own loop stood still for too long
  std::int64_t resyncs = 0;   // times that another generation took over
};

class Session {
 public:
  /// `initial` must be the same in all peers but for options.well; its own tracks are taken as
  /// fixed parts of the world. All balls become ghosts until the session is active. `transport`
  /// must outlive the session. Throws std::invalid_argument for options outside their ranges.
  Session(SessionOptions options, World& initial, Transport& transport);

  /// Receives what came, applies it, and decides what this peer does. Call once per tick of the
  /// simulation loop, before the steps.
  void beforeStep(World& world, Times now);

  /// Steps to do now: 0 while joining, syncing, stopped or too far ahead; more than 1 to catch up.
  int mayStep(const World& world, Times now);

  /// After each step, and once in a tick without a step: keeps the view and sends what is due.
  void afterStep(World& world, Times now);

  /// What anybody has set for all, so far. The session obeys its own keys; the application obeys
  /// the others, from their steps on.
  const SharedSettings& settings() const { return shared_; }

  /// Steps per wall second that the group is to do now.
  double stepRate(const World& world) const {
    return wells::stepRate(shared_, world.step, options_.stepRate);
  }

  /// Does no step beyond `step`; at it, the session counts as paused and goes on publishing.
  void stopAt(std::int64_t step) { stopAt_ = step; }

  /// Publishes the last states and says good-bye: the others adopt at once. The session is over.
  void leave(World& world, Times now);

  /// For the statistics message, which goes out each second.
  void setMeasures(const SessionMeasures& measures) { measures_ = measures; }

  Phase phase() const { return phase_; }
  const Incarnation& self() const { return self_; }
  PeerId peer() const { return self_.peer; }
  const Generation& generation() const { return generation_; }

  /// True when the stop is reached, no offer is open and every ball has, here, the state that its
  /// owner published for this step. When all peers of a group say so, their views are equal to the
  /// bit.
  bool isComplete(const World& world) const;

  /// True when every other active peer whose lease lasts has said that it is complete.
  bool areOthersComplete(Times now) const;

  /// Records by ball. Empty of meaning until the session is active.
  const std::vector<Record>& records() const { return balls_.records(); }

  /// Who owns a ball, or has been named and not yet heard.
  PeerId ownerOf(BallId ball) const { return records()[index(ball)].version.owner.peer; }

  /// Balls of each owner, by rising id.
  std::vector<std::pair<PeerId, std::size_t>> ballsOwned() const;
  std::size_t ballsOwnedHere() const { return records().size() - balls_.ghosts(); }

  /// Active peers whose lease lasts, by rising id, this one included when it is active.
  std::vector<PeerId> livingPeers(Times now) const;

  /// Largest distance (m) between where a ball was shown here and where its owner's state, which
  /// came later, had it at the same step: since the start, and over the last second.
  double viewDifference() const { return balls_.viewDifference().largest(); }
  double recentViewDifference(Times now) const {
    return balls_.viewDifference().recent(now.monotonic);
  }

  SessionCounts counts() const;

 private:
  // session_phases.cpp
  void listen(World& world, Times now);
  void synchronise(World& world, Times now);
  void act(World& world, Times now);
  void found(World& world, std::int64_t resets, Times now);
  void enter(World& world, const Generation& generation, Times now);
  void followGroup(World& world, Times now);
  bool knowsAllWells(const World& world, Times now) const;
  /// True when this peer may take part; where that fails for too long it forgets what it knows.
  bool trySynchronise(World& world, Times now);
  void forgetOwners(World& world, Times now);
  bool isLowest(Times now) const;
  /// When everybody who was active has gone.
  bool isItsTurnToGoOn(Times now) const;
  void activate(World& world, Times now);
  void fence(World& world, PeerId peer, Times now);
  void fenceAfterStall(World& world, Times now);
  void takeIncarnation(PeerId peer, Times now);
  void showWell(World& world);
  void tendWells(World& world, Times now);
  Generation greatestHeard(double now) const;
  Generation greatestOfOthers(double now) const;

  // session_receive.cpp
  void receive(World& world, std::string_view channel, std::span<const std::byte> bytes, Times now);
  std::optional<Drop> heed(World& world, const Message& message, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::heartbeat_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::wells_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::ball_states_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::offers_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::world_config_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::statistics_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::settings_t& m, Times now);
  std::optional<Drop> hear(World& world, const gravity_wells::request_t& m, Times now);
  std::optional<Drop> checkMember(const gravity_wells::peer_header_t& header, Times now);
  std::optional<Drop> settleId(World& world, const Peer& other, Times now);
  void giveUpId(World& world, Times now);
  std::optional<Drop> learn(World& world, const std::vector<gravity_wells::setting_t>& settings,
                            Times now);
  void hearDigests(const World& world, const Peer& other, const gravity_wells::heartbeat_t& m,
                   Times now);
  void noteForeignWorld(Peer& other, const std::string& canonical);
  void noteClock(const gravity_wells::peer_header_t& header, Times now);

  // session_send.cpp
  void publish(World& world, Times now);
  gravity_wells::peer_header_t header(const World& world, Times now);
  void send(const Message& message);
  /// Ends the lease of the present incarnation everywhere. Sets the phase.
  void sayGoodBye(const World& world, Times now);
  void sendHeartbeat(const World& world, Times now);
  void addDigests(gravity_wells::heartbeat_t& m, Times now);
  void sendSettings(const World& world, Times now);
  void sendConfig(const World& world, Times now);
  void sendWells(const World& world, Times now);
  void sendStates(const World& world, const std::vector<std::uint32_t>& chosen, Times now);
  void sendOffers(const World& world, Times now);

  // session_statistics.cpp
  void sendStatistics(const World& world, Times now);
  void addTrafficRates(gravity_wells::statistics_t& m, Times now);
  void addDrops(gravity_wells::statistics_t& m, const TransportCounts& transport) const;
  void addPeerViews(gravity_wells::statistics_t& m, const World& world, Times now) const;

  // session.cpp
  Party party() const { return {self_, phase_}; }
  bool isStopped(const World& world) const { return world.step >= stopAt_; }
  bool standsStill(const World& world) const;
  void applySettings(World& world) const;
  Hearing hearing(const gravity_wells::peer_header_t& header, Times now);
  std::vector<PeerPace> paces(double now) const;
  PaceRule paceRule(const World& world) const { return {.stepRate = stepRate(world)}; }
  double digestRound() const;
  std::vector<PeerWell> livingWells(const World& world, Times now) const;
  void note(const std::string& text) const;
  double listenTime() const { return options_.listen.value_or(2 * options_.lease); }

  SessionOptions options_;
  Transport& transport_;
  Random random_;
  SharedBalls balls_;
  Peers peers_;
  StateSchedule schedule_;
  SharedSettings shared_;
  Settings worldSettings_;  // without the shared ones

  Incarnation self_;
  std::vector<std::int64_t> formerIncarnations_;  // ours, to know the echo of our own messages
  std::int64_t startedUs_ = 0;
  std::int64_t sequence_ = 0;
  Generation generation_;
  Phase phase_ = Phase::Joining;
  double listenUntil_ = 0;          // s
  std::optional<double> lastLoop_;  // s, when our loop was last seen alive
  double lastActiveHeard_ = 0;      // s, while syncing
  double completeSince_ = 0;        // s; since when nothing but agreement is missing, while syncing
  bool hasForgotten_ = false;       // what nobody else seems to know, while syncing
  bool knowsSettings_ = false;      // as an active peer knows them; while syncing
  std::int64_t observedStep_ = -1;  // of the view that was kept last
  double stepTime_ = 0;             // s that a step lately took
  std::size_t nextBucket_ = 0;      // whose digest is sent next
  std::int64_t stopAt_ = std::numeric_limits<std::int64_t>::max();
  bool isWaiting_ = false;                 // the others are too far behind
  std::optional<double> clockApartSince_;  // s, when a clock was first found to be off
  bool clockIsNoted_ = false;              // the user was told of a clock that is off
  std::exception_ptr error_;               // found while receiving, thrown afterwards

  // When the next of each is due, s.
  double nextHeartbeat_ = 0, nextConfig_ = 0, nextStatistics_ = 0, nextWell_ = 0, nextStates_ = 0;
  double nextForget_ = 0, nextAdoption_ = 0, nextSettings_ = 0;
  std::int64_t nextOffers_ = 0;  // step

  /// Messages and bytes so far, when the statistics were sent last.
  struct Traffic {
    double time = 0;  // s
    std::int64_t messagesSent = 0, messagesReceived = 0, bytesSent = 0, bytesReceived = 0;
  };
  Traffic traffic_;
  SessionMeasures measures_;
  SessionCounts counts_;
};

}  // namespace wells
