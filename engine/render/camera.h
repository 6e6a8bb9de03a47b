// Where the picture is taken from. Plain data and the geometry that follows from it; no drawing.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "math/vector.h"
#include "state/arena.h"

namespace wells {

struct Camera {
  Vec3 eye = Vec3{0, 60, 80};  // m
  Vec3 target = Vec3::Zero();  // m, appears in the picture's middle; not the eye
  double fieldOfView = 35;     // degrees, vertical, in (0, 180)
};

/// Unit vectors of the picture in the world. Looking straight down, -z is up.
struct CameraAxes {
  Vec3 right, up, forward;
};

CameraAxes cameraAxes(const Camera& camera);

/// The rim round the arena is drawn this high, m. (The wall itself has no top.)
double rimHeight(const Arena& arena);

/// Looks obliquely down at the arena, as near as still shows all of it, rim and some headroom
/// included. `aspect` is the picture's width over its height.
Camera cameraOverArena(const Arena& arena, double aspect);

/// From world coordinates minus `origin` to clip space (x right, y up, -w .. w; infinitely far is
/// z = w). What is nearer than nearDistance(camera) is cut.
Eigen::Matrix4d viewProjection(const Camera& camera, double aspect, const Vec3& origin);

/// m; a small part of the distance to the target, so that depth is resolved well around it.
double nearDistance(const Camera& camera);

/// Where a point appears: x and y in -1 .. 1 inside the picture, y up. Empty: behind the eye.
std::optional<Eigen::Vector2d> project(const Camera& camera, double aspect, const Vec3& point);

}  // namespace wells
