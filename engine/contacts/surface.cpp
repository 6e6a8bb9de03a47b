#include "contacts/surface.h"

#include "math/elementary.h"

namespace wells {

Surface::Surface(const Arena& arena, std::uint32_t which, const Vec3& center, double radius)
    : origin_(center) {
  if (which == kGround) {
    frame_ = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    origin_.y() = arena.center.y() + radius;
    return;
  }
  const Vec3 fromAxis(center.x() - arena.center.x(), 0, center.z() - arena.center.z());
  const Vec3 outward = fromAxis / length(fromAxis);
  frame_ = {{-outward.z(), 0, outward.x()}, {0, 1, 0}, -outward};
  curvature_ = 1 / (arena.radius - radius);
  origin_ = arena.center + (arena.radius - radius) * outward;
  origin_.y() = center.y();
}

Surface::Spot Surface::at(Flat place) const {
  if (curvature_ == 0) return {frame_, origin_ + frame_.vector(place)};
  const SinCos turned = sinCosOfTurns(place.x * curvature_ / (2 * kPi));
  const Frame frame{turned.cos * frame_.x + turned.sin * frame_.normal, frame_.y,
                    turned.cos * frame_.normal - turned.sin * frame_.x};
  // From the origin, so that a short way loses no digits.
  const Vec3 way = (turned.sin * frame_.x + (1 - turned.cos) * frame_.normal) / curvature_;
  return {frame, origin_ + way + place.y * frame.y};
}

}  // namespace wells
