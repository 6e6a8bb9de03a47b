// How this peer's well moves, as the keyframes of a track. The path is the config's; nothing here
// depends on wall time.
#pragma once

#include <cstdint>
#include <vector>

#include "config.h"
#include "state/wells.h"

namespace wells {

class OwnWell {
 public:
  /// Keyframes of a circle are this far apart; between them the well moves in a straight line.
  static constexpr double kCircleInterval = 0.1;  // s

  /// Reads the keyframe file, if the path is one. `dt` is the world's step, s. Throws UsageError.
  OwnWell(const Config& config, PeerId peer, double dt);

  /// Where the path starts: the keyframe of step 0.
  WellKeyframe start() const { return start_; }
  double softening() const { return softening_; }

  /// The keyframes with after < step <= last, in order.
  std::vector<WellKeyframe> keyframes(std::int64_t after, std::int64_t last) const;

  /// The track from step 0 to `last`.
  WellTrack track(std::int64_t last) const;

 private:
  void readKeyframes(const std::filesystem::path& file, double dt);
  std::vector<WellKeyframe> circleKeyframes(std::int64_t after, std::int64_t last) const;

  WellPath path_;
  PeerId peer_;
  double softening_;
  double dt_;
  WellKeyframe start_;
  Vec3 center_ = Vec3::Zero();          // m, of the circle
  Vec3 direction_ = Vec3::Zero();       // from it to the start, horizontal unit vector
  std::vector<WellKeyframe> fromFile_;  // those after step 0
};

}  // namespace wells
