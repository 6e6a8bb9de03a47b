// The peers of a session without their balls: who runs, as which incarnation, how far it has come,
// in which generation, and whom it suspects. Plain data, and every way in which it may change.
//
// What is left out, and why nothing is lost by it:
//  - Clocks, heartbeats and leases. Whatever they decide may happen at any time, as often as the
//    limits allow: to found (heard nobody), to enter any generation that was founded, to suspect.
//    A dead incarnation may be taken for dead at any time after its death, or never. One that lives
//    costs one of the false suspicions; that suspicion then lasts as long as the incarnation (a
//    real lease begins again when it is heard: less can come of it). It is counted when something
//    is done because of it; before that it would change nothing.
//  - Partitions: messages that do not come, and suspicions on both sides.
//  - Leaving. To the others a peer that left is one that crashed, all of whose messages were sent,
//    and those are in the network as soon as they can exist (knowledge.h).
//  - Peer ids that are given up for others: that is a fence and another peer.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "ownership/records.h"
#include "search/limits.h"
#include "search/transitions.h"

namespace wells {

inline constexpr int kMaxPeers = 3;
inline constexpr int kMaxGenerations = 3;

/// Incarnation numbers and times of founding are 1 .. kRanks - 1. Only their order matters. Real
/// ones come in any order (numbers are random, wall clocks differ), so each new one is tried in
/// every gap between those that were used before, and stands in the gap's middle.
inline constexpr int kRanks = 16;

struct Member {
  Phase phase = Phase::Joining;
  std::uint8_t number = 0;      // incarnation; 0: does not run
  std::uint8_t generation = 0;  // place in Group::generations + 1; 0: none

  auto operator<=>(const Member&) const = default;
};

struct Era {
  std::uint8_t founded = 0;  // rank of the time, another one for each; 0: not founded
  std::uint8_t resets = 0;
  // Who ever was active in it, by bitOf(): the others may believe for long after that it still is.
  std::uint64_t wasActive = 0;

  auto operator<=>(const Era&) const = default;
};

struct Group {
  std::array<Member, kMaxPeers> members{};
  std::array<Era, kMaxGenerations> generations{};
  std::array<std::uint16_t, kMaxPeers> numbersUsed{};  // bit by number
  std::array<std::uint8_t, kMaxPeers> suspects{};      // bit by peer, of its present incarnation
  std::uint8_t suspicions = 0, crashes = 0, restarts = 0, fences = 0, resets = 0;  // so far
  std::uint8_t eras = 0;                                                           // founded so far

  auto operator<=>(const Group&) const = default;
};

enum class Deed : std::uint8_t {
  // of a peer
  Found,
  Reset,
  Enter,
  Retreat,
  Activate,
  ActivateAlone,
  Crash,
  Restart,
  Fence,
  FenceAlone,
  // with a ball
  Hear,
  Take,
  Offer,
  Adopt,
  AdoptWrongly,
  Publish,
  Withdraw,
};

struct Event {
  Deed deed = Deed::Found;
  std::uint8_t peer = 0;      // who does it, counted from 0
  std::uint16_t subject = 0;  // Enter, Retreat: generation; Hear, Offer: the message's word
  std::uint16_t basis = 0;    // with a ball: the word of the record that it is done with
};

struct GroupMove {
  Event event;
  Group to;
  // The new incarnation's number is tried at another place in the order. That makes no difference
  // when no version names a former incarnation of the peer as its adopter: the numbers of others
  // are never compared, and those that are gone adopt nothing any more.
  bool isReordering = false;
};

/// Everybody has just started and listens.
Group newGroup(const Limits& limits);

/// True when `group` is only on its way: a peer that listens has nothing left to do but to enter
/// the one generation that there can be. It might as well do so before anything else happens: while
/// it syncs and has heard nothing, it does no more and no less to the others than while it listens.
bool isPassing(const Group& group, const Limits& limits);

/// All that may happen to `group` next. Activate may be forbidden by the balls. When the group is
/// passing, only what it is on its way to.
std::vector<GroupMove> movesOf(const Group& group, const Limits& limits, const Conduct& conduct);

inline std::uint64_t bitOf(int peer, int number) {
  return std::uint64_t{1} << (peer * kRanks + number);
}

inline Incarnation incarnationOf(int peer, int number) {
  return {PeerId{peer + 1}, number};
}

inline Party partyOf(const Group& group, int peer) {
  const Member& member = group.members[peer];
  return {incarnationOf(peer, member.number), member.phase};
}

/// Runs and belongs to a generation.
inline bool isMember(const Member& member) {
  return member.number != 0 && (member.phase == Phase::Syncing || member.phase == Phase::Active);
}

/// That of a member; none for generation 0.
Generation generationOf(const Group& group, int generation);

/// What `peer` knows, or may believe, of `owner`, an incarnation or nobody.
Life lifeOf(const Group& group, int peer, const Incarnation& owner, const Conduct& conduct);

/// `group` after `peer` has suspected `other`, which lives. Nothing when that would be one too
/// many.
std::optional<Group> afterSuspicion(const Group& group, int peer, int other, const Limits& limits);

/// True when somebody who knows nothing of this generation may yet come to listen in it.
bool mayAwaitNewcomers(const Group& group, int generation, const Limits& limits);

/// No false suspicion, crash, fence or second founding so far.
bool isCalm(const Group& group);

}  // namespace wells
