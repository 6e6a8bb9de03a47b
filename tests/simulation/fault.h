// What goes wrong in a simulated session, and when: plain data, so that a run can be printed,
// replayed and shrunk.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wells::simulation {

enum class FaultKind : std::uint8_t {
  // To a process.
  Start,             // the slot's peer starts; again, if it has left or crashed
  RestartStale,      // the same, and what its former process sent last arrives once more
  DuplicateId,       // another process starts with the id that this peer has
  Crash,             // as kill -9
  CrashBeforeOffer,  // ... when it is about to send an offer
  CrashAfterOffer,   // ... when it has just sent one
  CrashAfterAnswer,  // ... when the ball that it offered has been published by its new owner
  Leave,             // says good-bye
  Stall,             // SIGSTOP between two ticks: clocks go on, messages wait
  StallMidTick,      // SIGSTOP after it has received and before it sends
  Slow,              // its loop runs ten times slower
  ClockJump,         // its wall clock is set to another time
  TinyBuffer,        // its receive buffer holds `amount` messages
  // To links.
  Mute,     // nobody hears it
  Deaf,     // it hears nobody
  Isolate,  // both
  CutLink,  // one other peer does not hear it
  // To the network.
  Loss,         // probability `amount`
  Duplication,  // probability `amount`
  Delay,        // up to `amount` s, so that messages overtake each other
  ReplayLog,    // what was sent `amount` s ago arrives once more
  Forge,        // malformed, truncated, foreign and invented messages arrive
  // To the session.
  Pause,    // somebody pauses it, for `duration`
  Reset,    // somebody lets the world start over
  Setting,  // somebody changes a shared setting
};

inline constexpr std::array<std::string_view, 25> kFaultNames = {"start",
                                                                 "restart stale",
                                                                 "duplicate id",
                                                                 "crash",
                                                                 "crash before offer",
                                                                 "crash after offer",
                                                                 "crash after answer",
                                                                 "leave",
                                                                 "stall",
                                                                 "stall mid-tick",
                                                                 "slow",
                                                                 "clock jump",
                                                                 "tiny buffer",
                                                                 "mute",
                                                                 "deaf",
                                                                 "isolate",
                                                                 "cut link",
                                                                 "loss",
                                                                 "duplication",
                                                                 "delay",
                                                                 "replay log",
                                                                 "forge",
                                                                 "pause",
                                                                 "reset",
                                                                 "setting"};
inline constexpr std::size_t kFaultKinds = kFaultNames.size();

constexpr std::string_view name(FaultKind kind) {
  return kFaultNames.at(static_cast<std::size_t>(kind));
}

/// What a peer is in the middle of. It can be several of the active ones at once.
enum class PeerState : std::uint8_t {
  Joining,
  Syncing,
  OwnsNothing,  // active, without balls
  Owns,         // active, with balls
  Offering,     // an offer that it made is open
  Named,        // is the next owner of a ball that it has not taken yet
  Bereft,       // active, and the owner of a ball that it knows is gone
  Paused,       // active, at the step at which all stop
  Leaving,
};

inline constexpr std::array<std::string_view, 9> kPeerStateNames = {
    "joining", "syncing", "owns nothing", "owns",   "offering",
    "named",   "bereft",  "paused",       "leaving"};
inline constexpr std::size_t kPeerStates = kPeerStateNames.size();

constexpr std::string_view name(PeerState state) {
  return kPeerStateNames.at(static_cast<std::size_t>(state));
}

/// A set of states.
class PeerStates {
 public:
  void add(PeerState state) { bits_ |= 1u << static_cast<unsigned>(state); }
  bool contains(PeerState state) const { return bits_ >> static_cast<unsigned>(state) & 1u; }

 private:
  unsigned bits_ = 0;
};

struct Fault {
  static constexpr int kAnySlot = -1;

  double at = 0;  // s
  FaultKind kind = FaultKind::Crash;
  int slot = 0;   // whom it hits; kAnySlot: whoever is in the state
  int other = 0;  // the slot at the other end of a cut link
  /// It strikes as soon as the peer is in this state, if that is within kPatience of `at`.
  std::optional<PeerState> state{};
  double amount = 0;    // of who dies or leaves, 1: comes back as with RestartStale
  double duration = 0;  // s; of what lasts; of who dies or leaves: until it comes back, 0: never

  static constexpr double kPatience = 12;  // s

  bool operator==(const Fault&) const = default;
};

/// How a run goes: everything that is drawn from the seed but what befalls single messages.
struct Schedule {
  std::uint64_t seed = 1;
  int peers = 3;
  int balls = 8;
  double heal = 48;           // s, when all faults end
  double stop = 61;           // s, when the world is stopped to compare the views
  double end = 66;            // s
  double latency = 0;         // s, of a message when nothing is wrong; as much again is jitter
  std::vector<Fault> faults;  // by rising time

  bool operator==(const Schedule&) const = default;
};

/// The slot is a peer of the group; the id that it prefers is slot + 1.
std::string describe(const Fault& fault);

/// One fault a line.
std::string describe(const Schedule& schedule);

}  // namespace wells::simulation
