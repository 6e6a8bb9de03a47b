// The wells of a session as tracks in the world: each peer makes the keyframes of its own well a
// little in the future, everybody applies the same ones, and so all see the same well at the same
// step. Pure functions on the tracks; messages are sent and received elsewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <gravity_wells/wells_t.hpp>
#include <vector>

#include "network/session_options.h"
#include "ownership/handover.h"
#include "state/world.h"

namespace wells {

inline constexpr std::int64_t kKeyframeInterval = 6;  // steps, a tenth of a second
inline constexpr std::int64_t kInputDelay = 12;       // steps that a keyframe is ahead
inline constexpr std::int64_t kKeptSteps = 240;  // of past keyframes, for states that come late

using Tracks = std::vector<WellTrack>;

/// When a well that is new begins to act.
enum class Appearance : std::uint8_t {
  AtOnce,   // its world begins with it
  Delayed,  // after the input delay: the others must hear of it first
};

/// Adds the track of our own well, as of `step`. Tracks are kept in order of their peers, the fixed
/// ones first, so that all peers sum up their pulls in the same order.
void addOwnTrack(Tracks& tracks, PeerId self, const OwnWell& well, std::int64_t step,
                 Appearance appearance);

/// Makes the keyframes that are due at `step`. They lie at multiples of the interval.
void extendOwnTrack(Tracks& tracks, PeerId self, const OwnWell& well, std::int64_t step);

/// Switches the well of a peer that is gone off, if there is one, after the input delay. Its
/// owner's keyframes lie at multiples of the interval and these between them, so that all tracks
/// can be united. Should the owner still live, its next keyframe switches the well on again.
void switchOff(Tracks& tracks, PeerId gone, std::int64_t step);

/// True when the last keyframe of the track has strength 0.
bool isSwitchedOff(const WellTrack& track);

/// The last keyframes of a peer's well, without a header.
gravity_wells::wells_t wellMessage(const Tracks& tracks, PeerId peer);

/// What a message changed.
enum class TrackNews : std::uint8_t {
  None,
  InTime,  // for steps to come
  Late,    // for steps that are done: what we computed in them was wrong
};

/// Takes what is new in a message to a peer that stands at `step`. A keyframe that we have is never
/// changed.
TrackNews learnTrack(Tracks& tracks, const gravity_wells::wells_t& message, std::int64_t step);

/// Removes the peers' wells (never the fixed ones) that are `superfluous`.
void removeTracks(Tracks& tracks, const std::function<bool(const WellTrack&)>& superfluous);

/// Forgets keyframes that nothing after step - kKeptSteps needs.
void pruneTracks(Tracks& tracks, std::int64_t step);

/// Where the peers' wells stand at the world's step.
std::vector<PeerWell> peerWells(const World& world);

}  // namespace wells
