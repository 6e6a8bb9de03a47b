// How the peers of a group keep together in simulated time: everybody steps by its own timer, takes
// the steps that it is behind in portions, and waits when it is too far ahead. Pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "ownership/leases.h"

namespace wells {

/// What is known of another active peer's steps.
struct PeerPace {
  std::int64_t step = 0;  // committed, as last heard ...
  double heardAt = 0;     // ... at this time, s
  Progress progress = Progress::Running;
};

struct PaceRule {
  double stepRate = 60;        // Hz, steps per wall second that the group is meant to do
  std::int64_t slack = 3;      // steps behind the front that nobody chases
  std::int64_t maxAhead = 30;  // steps ahead of the slowest
  int maxCatchUp = 4;          // steps at once ...
  double longestTick = 0.05;   // ... which together take no longer than this, s
};

/// The step that a peer has probably reached by now.
std::int64_t estimatedStep(const PeerPace& peer, const PaceRule& rule, double now);

/// The step of the peer that is furthest, by what it has probably done since it was heard; nothing
/// without peers.
std::optional<std::int64_t> frontStep(std::span<const PeerPace> peers, const PaceRule& rule,
                                      double now);

/// Steps to do now, at a tick of the own timer, by a peer that stands at `step` and needs
/// `stepTime` (s) for one: 0 .. maxCatchUp. A peer that is silent is not waited for: it may be
/// gone. One that is paused is none that is slow.
int stepsDue(std::int64_t step, double stepTime, std::span<const PeerPace> peers,
             const PaceRule& rule, double now);

/// Steps to do now in a session that is paused: up to the furthest peer, so that all stop at one
/// step.
int stepsDueInPause(std::int64_t step, std::span<const PeerPace> peers, const PaceRule& rule);

}  // namespace wells
