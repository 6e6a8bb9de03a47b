// Who really hears whom: what the simulator knows from the messages that it has handed over, apart
// from what the sessions believe. The promises that hold "among peers that have heard each other
// for two leases" are judged by this.
#pragma once

#include <gravity_wells/heartbeat_t.hpp>
#include <limits>
#include <vector>

#include "network/peers.h"

namespace wells::simulation {

/// What one process has heard of each incarnation.
class Contacts {
 public:
  explicit Contacts(double lease) : lease_(lease) {}

  /// A message of `header`, handed over at `now` to a session of `generation`.
  void hear(const gravity_wells::peer_header_t& header, const Generation& generation, double now);
  void hear(const gravity_wells::heartbeat_t& heartbeat, const Generation& generation, double now);

  /// True when for the last `span` seconds no renewal of its lease was late.
  bool isSteady(const Incarnation& who, double span, double now) const;

  /// The same with so little silence that its wells are known as well as its life.
  bool isClose(const Incarnation& who, double span, double now) const;

  /// Everybody but `known` has been silent for `span`, as far as it has a say in the generation.
  bool hearsOnly(const std::vector<Incarnation>& known, double span, double now) const;

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  // Of a lease. A gap that is longer ends what was steady: it may have been too long for the
  // session, whose look at the time comes later.
  static constexpr double kSteadyGap = 0.75;
  static constexpr double kCloseGap = 0.25;

  struct Heard {
    Incarnation who{};
    Generation generation{};
    Phase phase = Phase::Joining;
    SequenceWindow sequences{};
    std::int64_t newestHeartbeat = 0;  // its sequence number
    std::int64_t newest = 0;           // sequence number of any message
    double steadySince = kNever;       // s
    double closeSince = kNever;        // s
    double renewed = kNever;           // s
    double asMember = kNever;          // s, when it was last heard with a say
  };
  Heard* find(const Incarnation& who);
  const Heard* find(const Incarnation& who) const;

  double lease_;
  std::vector<Heard> heard_;
};

}  // namespace wells::simulation
