// The parts of a peer about its engine, for the benchmark "features": the recorder, the graphics
// thread, and a session over a network in memory.
#pragma once

#include <cstdint>
#include <filesystem>

#include "feature_list.h"
#include "state/world.h"

namespace wells {

enum class Recording : std::uint8_t {
  None,  // as with nothing asked for
  All    // books are kept, and measures taken in each step
};

/// An engine with a peer's recorder.
FeatureRun recordedRun(World start, Recording recording);

/// The same with a graphics thread that draws so many frames in a simulated second, the first one
/// at once.
FeatureRun watchedRun(World start, double framesPerSecond, const std::filesystem::path& folder);

/// The first of so many peers of a session, all of which have joined; each step of it is a tick of
/// its loop. What the others do is not timed.
FeatureRun sessionRun(const World& start, int peers);

}  // namespace wells
