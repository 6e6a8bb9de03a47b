// The ground or the wall as a ball's support: coordinates on it, and the frame that goes with them.
//
// A ball's centre that the surface holds moves on a surface parallel to it: on the plane one radius
// above the ground, or on the cylinder one radius inside the wall. Unrolled, both are flat: x and y
// are lengths along it from where the ball was first.
#pragma once

#include "contacts/contact.h"

namespace wells {

/// A vector in the unrolled surface.
struct Flat {
  double x = 0;  // along the wall; on the ground any direction
  double y = 0;  // across: up the wall
};

inline Flat operator+(Flat a, Flat b) {
  return {a.x + b.x, a.y + b.y};
}
inline Flat operator-(Flat a, Flat b) {
  return {a.x - b.x, a.y - b.y};
}
inline Flat operator*(double s, Flat a) {
  return {s * a.x, s * a.y};
}
inline double dot(Flat a, Flat b) {
  return a.x * b.x + a.y * b.y;
}
inline double length(Flat a) {
  return std::sqrt(dot(a, a));
}

inline Flat unit(Flat a) {
  return (1 / length(a)) * a;
}

/// Unit vectors, x cross y = normal; the normal points from the surface to the ball.
struct Frame {
  Vec3 x;
  Vec3 y;
  Vec3 normal;

  Flat flat(const Vec3& a) const { return {dot(a, x), dot(a, y)}; }
  Vec3 vector(Flat a) const { return a.x * x + a.y * y; }
};

class Surface {
 public:
  /// `which`: kGround or kWall. `center` (m) is a ball's centre; where it isn't at its radius from
  /// the surface, it is put there. Not on the wall's axis.
  Surface(const Arena& arena, std::uint32_t which, const Vec3& center, double radius);

  struct Spot {
    Frame frame;
    Vec3 center;  // m
  };
  /// At `place` (m) from the origin.
  Spot at(Flat place) const;

  /// Of the lines along x, 1/m: 0 on the ground, 1 / (arena radius - ball radius) on the wall.
  double curvature() const { return curvature_; }

 private:
  Frame frame_;  // at the origin
  Vec3 origin_;
  double curvature_ = 0;
};

}  // namespace wells
