// What a session is told when it starts, and how it refuses to go on.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "network/shared_settings.h"
#include "network/world_difference.h"
#include "ownership/handover.h"
#include "state/world.h"

namespace wells {

/// The session has no clock of its own: the caller passes the time in.
struct Times {
  double monotonic = 0;     // s, never goes back; any origin
  std::int64_t wallUs = 0;  // us since 1970-01-01 UTC
};

/// What to do when another peer already has our id.
enum class PeerIdChoice : std::uint8_t {
  Preferred,  // take the lowest free one
  Explicit,   // throw PeerIdTaken
};

/// The well that this peer controls: where it is to be at a step, and how strong. The id is passed
/// because it may have been given up for another one, and where a well stands may depend on it.
struct OwnWell {
  double softening = 2;  // m, > 0
  std::function<WellKeyframe(PeerId peer, std::int64_t step)> at;
};

/// The state at the start of step `to` of a ball that nobody touches: wells::predict of our engine,
/// or what another engine has instead.
using Predictor =
    std::function<BallState(const World& world, std::size_t ball, const BallState& state,
                            std::int64_t from, std::int64_t to)>;

struct SessionOptions {
  PeerId peer{1};
  PeerIdChoice idChoice = PeerIdChoice::Preferred;
  std::uint64_t seed = 0;  // of incarnations and nonces: must differ at every start of every peer

  double lease = 2;                // s; silence after which a peer counts as gone, 0.05 .. 60
  std::optional<double> listen;    // s before a joiner founds or joins; nothing: two leases
  double clockTolerance = 30;      // s; messages whose wall clock is further from ours are refused
  double heartbeatRate = 10;       // Hz
  double stateRate = 30;           // Hz, of the states of a moving ball
  double stepRate = 60;            // Hz, steps per wall second that the group is meant to do
  std::size_t ballsPerTick = 240;  // at most so many states are sent each 1/stateRate, >= 12
  HandoverRule handover{};

  std::string canonicalConfig;  // KEY=VALUE lines in a fixed order, at most 1000 bytes
  DefaultValue defaultOf;       // of its keys, which are listed where they differ
  std::int64_t worldHash = 0;   // of the world, content of its files included
  OwnWell well;
  Predictor predict;
  SettingCheck checkSetting;  // of keys that the application obeys; empty: there are none

  /// Told in a sentence what a user should know (another id, a foreign world, ...). May be empty.
  std::function<void(const std::string&)> notice;
};

/// Another peer has the id that the user insists on, or no id is free.
class PeerIdTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The group that we wanted to join simulates another world.
class WorldMismatch : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wells
