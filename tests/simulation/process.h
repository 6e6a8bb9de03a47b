// A peer's process in the simulator: a session with its world, its clocks and its loop, cut into
// halves so that it can be stopped or killed between receiving and sending.
#pragma once

#include <memory>
#include <optional>

#include "network/session.h"
#include "simulation/contacts.h"
#include "simulation/fault.h"
#include "simulation/invariants.h"
#include "simulation/watched_transport.h"

namespace wells::simulation {

inline constexpr double kLease = 2;  // s

class Process {
 public:
  /// Where a process comes from.
  struct Birth {
    int number = 0;  // of the process: 0, 1, 2 ... in the order of their starts
    int slot = 0;
    PeerId id{1};  // that it prefers
    int balls = 8;
    std::uint64_t seed = 1;
    double clockOffset = 0;  // s, of its wall clock
  };

  Process(const Birth& birth, std::shared_ptr<MemoryNetwork> network, WatchedTransport::Watch watch,
          std::function<void(const std::string&)> notice);

  /// Receives and decides. Throws as Session::beforeStep.
  void receive(double now);
  /// Steps and sends.
  void send(double now);
  void leave(double now);

  /// All that there is to check.
  PeerView view() const;

  int number() const { return birth_.number; }
  int slot() const { return birth_.slot; }
  /// The one that it has, or wants to have.
  PeerId id() const { return session_->peer() == kNobody ? birth_.id : session_->peer(); }
  Session& session() { return *session_; }
  const Session& session() const { return *session_; }
  const World& world() const { return world_; }
  WatchedTransport& transport() { return transport_; }
  const WatchedTransport& transport() const { return transport_; }
  Contacts& contacts() { return contacts_; }
  const Contacts& contacts() const { return contacts_; }
  Times times(double now) const;
  void setClockOffset(double seconds) { birth_.clockOffset = seconds; }

  /// Tells of each record that has another owner or standing than at the last call.
  void learn(
      const std::function<void(std::size_t ball, const Record& before, const Record& after)>& tell);

  /// True when an offer of the ball that this incarnation made has not been answered here.
  bool hasOpenOffer(std::size_t ball) const;

  /// s of simulated time: from a tick's end to the next one's start.
  double tick();

  // The simulator's business.
  double next = 0;                                         // s, when it goes on
  double ticked = 0;                                       // s, when it last sent
  bool isMidTick = false;                                  // it has received and not yet sent
  bool stallsMidTick = false;                              // when next it has received ...
  double stall = 0;                                        // ... for so long, s
  bool losesMessages = false;                              // its receive buffer is too small
  double lastLoss = 0;                                     // s, until when that was so
  double slowness = 1;                                     // factor of the time between two ticks
  std::optional<Fault> doom;                               // dies at the next offer, as this says
  std::optional<std::pair<std::size_t, Version>> offered;  // dies when this was answered
  double gone = 0;  // s, when it ends after its good-bye; 0: has not left
  bool isKilled = false;
  std::optional<Fault> comeback;  // when it has ended, it starts again as this says
  double syncingSince = 0;        // s
  double activeSince = 0;         // s; as this incarnation, in this generation
  // What was seen of it last, for the log and for the counts.
  Phase phase = Phase::Joining;
  Incarnation self{};
  Generation generation{};
  SessionCounts counts{};

 private:
  Birth birth_;
  double rate_;    // of its clocks
  double origin_;  // s, of its monotonic clock
  Random random_;
  World world_;
  WatchedTransport transport_;
  Contacts contacts_{kLease};
  std::unique_ptr<Session> session_;
  int stepsDue_ = 0;
  std::vector<Record> known_;  // at the last learn()
  std::vector<Version> made_;  // by ball: the last offer
};

}  // namespace wells::simulation
