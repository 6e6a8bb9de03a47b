// Gravity wells: where they are now, and the keyframes by which they move.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/ids.h"
#include "math/vector.h"

namespace wells {

/// A well as it acts during one step. The acceleration of a ball at p is
///   a = strength * d / (|d|^2 + softening^2)^(3/2),  d = position - p
/// (Plummer softening: Aarseth 1963, MNRAS 126, 223), the potential per mass
///   -strength / sqrt(|d|^2 + softening^2).
struct Well {
  Vec3 position = Vec3::Zero();  // m, at the start of the step
  Vec3 velocity = Vec3::Zero();  // m/s, constant during the step
  double strength = 0;           // m^3/s^2; > 0 attracts, < 0 repels, 0 is off
  double softening = 2;          // m, > 0
  PeerId peer = kNobody;         // whose well it is; kNobody: fixed part of the world
};

/// Where a well is at a step.
struct WellKeyframe {
  std::int64_t step = 0;
  Vec3 position = Vec3::Zero();  // m
  double strength = 0;           // m^3/s^2, holds from this step to the next keyframe
};

/// A well's motion: keyframes in rising order of step, linear in between, at rest before the first
/// and after the last. At least one keyframe.
struct WellTrack {
  std::vector<WellKeyframe> keyframes;
  double softening = 2;   // m, > 0
  PeerId peer = kNobody;  // whose well it is
};

/// The well of `track` as it acts during the step that starts at `step`; dt in s.
Well wellAt(const WellTrack& track, std::int64_t step, double dt);

/// A horizontal circle, travelled at constant speed.
struct CirclePath {
  Vec3 center = Vec3::Zero();  // m
  double radius = 0;           // m, >= 0
  double period = 1;           // s, not 0; > 0 goes from +x towards +z
  double phase = 0;            // turns
};

/// Position on a circle at time t (s).
Vec3 positionOnCircle(const CirclePath& path, double t);

}  // namespace wells
