#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wells {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

CameraAxes cameraAxes(const Camera& camera) {
  const Vec3 forward = (camera.target - camera.eye).normalized();
  // Straight up or down the horizon gives no direction, so north takes its place.
  const Vec3 upHint = std::abs(forward.y()) < 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, -1};
  const Vec3 right = cross(forward, upHint).normalized();
  return {right, cross(right, forward), forward};
}

double rimHeight(const Arena& arena) {
  return 0.05 * arena.radius;
}

Camera cameraOverArena(const Arena& arena, double aspect) {
  constexpr double kElevation = 40 * kDegree;
  constexpr double kFieldOfView = 32;  // degrees; narrow, so that near and far balls compare well
  constexpr double kMargin = 0.95;     // of the picture's half width and height
  constexpr double kHeadroom = 0.12;   // of the radius; as much is seen over the whole ground
  constexpr int kSamples = 180;

  const CameraAxes axes =
      cameraAxes({Vec3{0, std::sin(kElevation), std::cos(kElevation)}, Vec3::Zero(), kFieldOfView});
  const double tangentY = kMargin * std::tan(kFieldOfView / 2 * kDegree);
  const double tangentX = tangentY * aspect;

  // In camera axes about the arena's centre, with the eye at (0, Y, -D), a point (x, y, z) is
  // inside when |x| <= tangentX (z + D) and |y - Y| <= tangentY (z + D). The largest sides
  // over the arena's edge give the smallest D and bounds for Y. What room remains goes above,
  // where the legend is and balls fly.
  double side = 0, above = -INFINITY, below = -INFINITY;
  for (int i = 0; i < kSamples; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSamples;
    for (const double height : {0.0, kHeadroom * arena.radius}) {
      const Vec3 point{arena.radius * std::cos(angle), height, arena.radius * std::sin(angle)};
      const double x = dot(point, axes.right);
      const double y = dot(point, axes.up);
      const double z = dot(point, axes.forward);
      side = std::max(side, std::abs(x) / tangentX - z);
      above = std::max(above, y - tangentY * z);
      below = std::max(below, -y - tangentY * z);
    }
  }
  const double distance = std::max(side, (above + below) / (2 * tangentY));
  const Vec3 target = arena.center + (tangentY * distance - below) * axes.up;
  return {target - distance * axes.forward, target, kFieldOfView};
}

double nearDistance(const Camera& camera) {
  return 0.005 * length(camera.target - camera.eye);
}

Eigen::Matrix4d viewProjection(const Camera& camera, double aspect, const Vec3& origin) {
  const CameraAxes axes = cameraAxes(camera);
  const Vec3 eye = camera.eye - origin;
  const double scale = 1 / std::tan(camera.fieldOfView / 2 * kDegree);
  Eigen::Matrix4d m;
  m.row(0) << scale / aspect * axes.right.transpose(), -scale / aspect * dot(axes.right, eye);
  m.row(1) << scale * axes.up.transpose(), -scale * dot(axes.up, eye);
  m.row(2) << axes.forward.transpose(), -dot(axes.forward, eye) - 2 * nearDistance(camera);
  m.row(3) << axes.forward.transpose(), -dot(axes.forward, eye);
  return m;
}

std::optional<Eigen::Vector2d> project(const Camera& camera, double aspect, const Vec3& point) {
  const Vec3 relative = point - camera.eye;
  const Eigen::Vector4d clip = viewProjection(camera, aspect, camera.eye) *
                               Eigen::Vector4d(relative.x(), relative.y(), relative.z(), 1);
  if (clip.w() <= 0) return std::nullopt;
  return Eigen::Vector2d(clip.x() / clip.w(), clip.y() / clip.w());
}

}  // namespace wells
