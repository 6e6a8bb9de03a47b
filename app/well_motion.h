// How this peer's well moves: where it is to be at any step. Depends on simulated time only.
#pragma once

#include <cstdint>

#include "config.h"
#include "state/wells.h"

namespace wells {

/// What becomes of the strength that config or keyframe file give.
enum class WellMode : std::uint8_t { AsConfigured, Attract, Repel, Off };

class WellMotion {
 public:
  /// Reads the keyframe file, if the path is one. `dt` is the world's step, s. Throws UsageError.
  WellMotion(const Config& config, double dt);

  /// From now on moves as another config says, whose path is none of a file unless it was before.
  void follow(const Config& config, WellMode mode);

  double softening() const { return config_.wellSoftening; }

  /// Where the well is to be at a step, and how strong. Depends on the peer by its default place.
  WellKeyframe at(PeerId peer, std::int64_t step) const;

  /// The well's track for the step that starts at `step`.
  WellTrack trackAt(PeerId peer, std::int64_t step) const;

  /// Extends a track of trackAt so that it covers a later step, with keyframes kInterval apart, and
  /// forgets those that no step from there on needs.
  void extend(WellTrack& track, std::int64_t step) const;

  /// Between two keyframes a well moves in a straight line.
  static constexpr double kInterval = 0.1;  // s

 private:
  void readKeyframes(const std::filesystem::path& file);
  WellKeyframe configuredAt(PeerId peer, std::int64_t step) const;
  Vec3 place(PeerId peer) const;

  Config config_;
  double dt_;
  WellMode mode_ = WellMode::AsConfigured;
  WellTrack fromFile_;
};

}  // namespace wells
