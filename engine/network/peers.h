// Everybody that a session has heard: which incarnations exist, which of them live, and which
// messages of theirs are new. Knows nothing of balls.
//
// What is accepted from whom:
//  - Only a heartbeat introduces an incarnation; what else comes from an unknown one is refused.
//  - A sequence number counts once (SequenceWindow). Entries are kept for longer than the clock
//    tolerance can hide the age of a message, so that a log played back into the group finds either
//    its sequence numbers or its wall clock refused.
//  - A member replaces an earlier one with its id that has been silent for half a lease: that one's
//    lease ends at once, and it is refused as long as the later one lives. A joiner replaces
//    nobody: it has yet to find an id.
//  - A lease that ended otherwise than by a good-bye begins again when the incarnation is heard,
//    with a new sequence number and an advancing step.
#pragma once

#include <cstdint>
#include <gravity_wells/heartbeat_t.hpp>
#include <map>
#include <optional>
#include <vector>

#include "network/drops.h"
#include "network/sequence_window.h"
#include "network/session_options.h"
#include "ownership/leases.h"
#include "ownership/phase.h"

namespace wells {

enum class WorldMatch : std::uint8_t { Same, Foreign };

struct Peer {
  Incarnation who{};
  std::int64_t startedUs = 0;  // us since 1970, its wall clock
  Generation generation{};
  Phase phase = Phase::Joining;
  Progress progress = Progress::Paused;
  bool complete = false;  // as Session::isComplete
  WorldMatch world = WorldMatch::Same;
  double lease = 0;        // s
  std::int64_t step = 0;   // committed, as last heard ...
  double stepHeardAt = 0;  // ... at this time, s
  double heardAt = 0;      // s
  double lostAt = 0;       // s; when its lease ran out in its last long silence ...
  double foundAt = -1e9;   // ... which ended then, s
  double clockOffset = 0;  // s; its wall clock minus ours, journey time included
  int heartbeats = 0;      // heard at different times, up to a few ...
  double countedAt = 0;    // ... the last of them then, s
  bool isOver = false;     // it said good-bye
  bool isNoted = false;    // the user was told about its world or its clock
  SequenceWindow sequences{};
  std::int64_t newestHeartbeat = 0;  // its sequence number

  /// Who started first keeps an id and founds a generation.
  bool startedBefore(std::int64_t otherStartedUs, std::int64_t otherIncarnation) const {
    return startedUs != otherStartedUs ? startedUs < otherStartedUs : who.number < otherIncarnation;
  }
};

class Peers {
 public:
  /// worldHash as in heartbeat_t; clockTolerance in s.
  Peers(std::int64_t worldHash, double clockTolerance)
      : worldHash_(worldHash), clockTolerance_(clockTolerance) {}

  /// The generation whose members have leases with us. The leases of those known began when they
  /// were heard last.
  void setGeneration(const Generation& generation);

  /// Learns from a heartbeat. The reason if the rest of the session must not heed it; a peer in
  /// another generation or world is entered in the table nevertheless.
  std::optional<Drop> hear(const gravity_wells::heartbeat_t& heartbeat, Times now);

  /// Learns from the header of any other message.
  std::optional<Drop> hear(const gravity_wells::peer_header_t& header, Times now);

  /// Whether the wall clock of a message is near enough to ours.
  std::optional<Drop> checkClock(const gravity_wells::peer_header_t& header, Times now) const;

  /// The peer of an incarnation number; nullptr when unknown.
  Peer* find(std::int64_t incarnation);

  /// Members of the generation whose lease lasts, by incarnation.
  std::vector<const Peer*> living(double now) const;
  std::vector<const Peer*> livingActive(double now) const;

  /// Everybody who has lately been heard and simulates the same world, joiners included.
  std::vector<const Peer*> audible(double now) const;

  /// Somebody who has lately been heard, simulates another world, and has been here for longer
  /// than we, if there is one.
  const Peer* foreignSenior(std::int64_t ourStartedUs, std::int64_t ourIncarnation,
                            double now) const;

  /// True when a member of our generation, dead or alive by now, was heard since `time`.
  bool heardMemberSince(double time) const;

  /// Lowest id that nobody audible uses; nobody when all are taken.
  PeerId lowestFreeId(double now) const;

  /// Since when the peer may have thought us gone (s): since its lease here ran out, if it was
  /// heard again only lately; now, if there was no such silence.
  double apartSince(const Peer& peer, double now) const;

  /// Members of our generation, dead ones that are remembered included, by id.
  std::vector<const Peer*> members() const;

  /// When the lease of the last member with this id ended, s; -infinity: nobody is remembered.
  double goneSince(PeerId id, double now) const;

  /// Drops what is too old to matter.
  void forget(double now);

  Leases& leases() { return leases_; }
  const Leases& leases() const { return leases_; }

 private:
  // Incarnations in the table; more are refused. A flood of invented ones must not fill memory.
  static constexpr std::size_t kCapacity = 2048;

  bool isReplaced(const Peer& peer, double now) const;
  void renew(Peer& peer, std::int64_t step, double now);
  static void noteHeard(Peer& peer, double now);

  std::int64_t worldHash_;
  double clockTolerance_;
  Generation generation_;
  std::map<std::int64_t, Peer> peers_;  // by incarnation number
  Leases leases_;
};

}  // namespace wells
