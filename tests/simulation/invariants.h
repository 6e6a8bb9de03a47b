// What must hold in every session, whatever goes wrong: the promises, checked on what each peer
// knows and on what it says. Knows nothing of faults and networks; who hears whom is passed in.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "network/peers.h"
#include "network/shared_settings.h"
#include "ownership/records.h"
#include "state/world.h"

namespace wells::simulation {

enum class Invariant : std::uint8_t {
  OneOwnerEver,      // (ball, generation, term, adopter, its incarnation, epoch) has one owner ever
  VersionsRise,      // at a running incarnation, within a generation; of settings, too
  Complete,          // every ball in every record set, nothing that is not a number
  RolesMatch,        // a ball is owned in the world exactly where the record says so
  OneActsAsOwner,    // among peers that heard each other for two leases: one, or one is named
  NobodyForLong,     // ... and who is named takes it
  LivingKeepTheirs,  // nobody adopts from one whom it has heard, and who has heard it
  JoinersKnow,       // who becomes active knows all tenures that are older than a second
  Heals,             // two leases after the faults: one generation, one owner each
  AllReturn,         // ... and later every peer is active
  Agree,             // stopped and complete: equal records, equal states to the bit
  StatesFit,         // a ghost is where the state of its very version leads
  SilentGiveUp,      // who stood still for a lease is not the one it was
  OlderLasts,        // an active peer changes only to a session reset more often or founded earlier
  FoundersListen,    // for two leases before they found a session
  WellsAgree,        // complete: equal wells, none of who is gone; joiners know the others'
};

inline constexpr std::array<std::string_view, 16> kInvariantNames = {
    "one owner ever",  "versions rise",      "complete",       "roles match", "one acts as owner",
    "nobody for long", "living keep theirs", "joiners know",   "heals",       "all return",
    "agree",           "states fit",         "silent give up", "older lasts", "founders listen",
    "wells agree"};

constexpr std::string_view name(Invariant invariant) {
  return kInvariantNames.at(static_cast<std::size_t>(invariant));
}

struct Violation {
  Invariant invariant{};
  double time = 0;  // s
  std::string what;
};

/// A peer as it stands between two things that it does. What it refers to must outlive the call
/// that it is passed to.
struct PeerView {
  int process = 0;  // number of its process; a restarted peer has another one
  Incarnation self{};
  Phase phase = Phase::Joining;
  Generation generation{};
  std::int64_t step = 0;
  bool losesMessages = false;  // its receive buffer is too small
  std::span<const Record> records;
  std::span<const Role> roles;
  const Balls* balls = nullptr;
  std::uint64_t settings = 0;  // digest of the shared settings that it knows
  const SharedSettings::Registers* registers = nullptr;
  const std::vector<WellTrack>* tracks = nullptr;

  bool owns(std::size_t ball) const {
    return phase == Phase::Active && wells::owns(records[ball], self);
  }
};

class Invariants {
 public:
  /// balls in every world; leases in s.
  Invariants(std::size_t balls, double lease) : balls_(balls), lease_(lease) {}

  /// After anything that the peer did. `wasHeard` tells whether the peer and an incarnation have
  /// heard each other for two leases.
  void observe(const PeerView& peer, double now,
               const std::function<bool(const Incarnation&)>& wasHeard);

  /// A message says that version.owner has, or is to have, the ball.
  void claim(std::size_t ball, const Version& version, double now);

  /// ... and that `state` holds at the start of version.step.
  void tell(std::size_t ball, const Version& version, const BallState& state, double now);

  /// A peer that has synchronised becomes active; `others` are the active ones that it hears and
  /// that hear it.
  void joined(const PeerView& joiner, std::span<const int> others, double now);

  /// Peers that have heard each other, and nobody else, for two leases.
  void group(std::span<const PeerView> peers, double now);

  /// All peers, two leases or more after the faults have ended. Those that still join are let be.
  void healed(std::span<const PeerView> peers, double now);

  /// All peers, stopped and complete.
  void complete(std::span<const PeerView> peers, double now);

  /// Of something that the simulator finds itself.
  void report(Invariant invariant, double now, std::string what);

  const std::vector<Violation>& violations() const { return violations_; }

 private:
  using Tenure = std::tuple<Generation, std::int64_t, Incarnation, std::int64_t>;

  /// A tenure that a peer has known since `time`.
  struct Known {
    double time = 0;  // s
    Version version{};
  };
  /// Where the state of a version leads by `step` if nobody touches the ball.
  struct Course {
    Version version{};
    std::int64_t step = -1;  // -1: the state of the version is not known
    BallState state{};
  };
  /// What was seen of a process.
  struct Process {
    Incarnation self{};
    Phase phase = Phase::Joining;
    std::optional<double> born;   // s, when it was seen first ...
    double seen = 0;              // ... and last
    std::vector<Course> courses;  // by ball
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> settings;  // version and setter
    Generation generation{};
    std::vector<Record> records;
    std::vector<std::vector<Known>> history;  // by ball; the last second and one before
  };

  static Tenure tenureOf(const Version& v) { return {v.generation, v.term, v.adopter, v.epoch}; }

  /// True for all who have had the ball from one tenure to before another: an adopter may have
  /// learned of a later hand-over in the same moment.
  bool areAll(std::size_t ball, const Version& from, const Version& to,
              const std::function<bool(const Incarnation&)>& heard) const;
  void checkChange(const Process& process, const PeerView& peer, double now);
  void checkSettings(Process& process, const PeerView& peer, double now);
  void checkGhosts(Process& process, const PeerView& peer, double now);
  void learn(Process& process, const PeerView& peer, std::size_t ball, double now);
  Version knownFor(int process, std::size_t ball, double seconds, double now) const;

  std::size_t balls_;
  double lease_;
  std::vector<std::map<Tenure, Incarnation>> owners_{balls_};  // by ball
  std::vector<std::map<Version, BallState>> states_{balls_};   // by ball
  std::map<int, Process> processes_;
  /// Since when nobody of a group owns a ball, and until when that was seen.
  struct Unowned {
    double since = 0, seen = 0;  // s
  };
  std::map<std::pair<Incarnation, std::size_t>, Unowned> unowned_;  // by the group's first
  std::vector<Violation> violations_;
};

}  // namespace wells::simulation
