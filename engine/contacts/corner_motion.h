// How a ball moves in the corner, held by ground and wall at once: its centre runs round the circle
// of radius rho = arena radius - ball radius, and friction at both contacts changes its spin.
//
// Per mass, in the frame that goes round with the ball, x along the wall, y up, o outward: A the
// acceleration of fields and drag, v the velocity of the centre along x, k = 1 / rho, f and g the
// friction of wall and ground, N_w and N_g what they press with. The contact point of the wall
// slips by (a, b) along (x, y), that of the ground by (c, b) along (x, o): spin about x moves both
// by the same b. Newton and Euler for a solid sphere, I = 2/5 m r^2, in the turning frame (Landau &
// Lifshitz, Mechanics, sections 36 and 38):
//   v' = A_x + f_x + g_x                  b' = 5/2 (f_y + g_o) + k v (c - v)
//   a' = A_x + 7/2 f_x + g_x              c' = A_x + f_x + 7/2 g_x - k v b
//   N_w = k v^2 + A_o + g_o               N_g = -A_y - f_y
// Friction across one contact loads or unloads the other. A contact that slides has
// |friction| = mu N against its slip, one that rolls no slip. Four motions are possible:
//   sliding on both;
//   rolling on the wall, sliding on the ground (a = b = 0: f_y = 2/5 k v (v - c), g_o = 0);
//   rolling on the ground, sliding on the wall (c = b = 0: g_o = 2/5 k v^2, f_y = 0);
//   rolling on both (f_x = g_x = -2/9 A_x, so v' = 5/9 A_x; f_y + g_o = 2/5 k v^2).
// In the last the contacts share what turns the spin, and its laws don't say how. It goes on as
// long as some share holds in which neither works against the other, 0 <= f_y <= 2/5 k v^2.
#pragma once

#include "contacts/held_motion.h"

namespace wells {

/// State of a ball in the corner.
struct Cornered {
  double place = 0;       // m, along the circle
  double speed = 0;       // m/s, v
  double wallSlip = 0;    // m/s, a
  double groundSlip = 0;  // m/s, c
  double across = 0;      // m/s, b
};

inline Cornered operator+(const Cornered& a, const Cornered& b) {
  return {a.place + b.place, a.speed + b.speed, a.wallSlip + b.wallSlip,
          a.groundSlip + b.groundSlip, a.across + b.across};
}
inline Cornered operator*(double s, const Cornered& a) {
  return {s * a.place, s * a.speed, s * a.wallSlip, s * a.groundSlip, s * a.across};
}

/// On it, per mass (m/s^2).
struct CornerForces {
  Flat wallFriction;    // f: along x, up
  Flat groundFriction;  // g: along x, outward
  double wall = 0;      // N_w
  double ground = 0;    // N_g
};

/// What ends a motion in the corner, or comes next to it.
enum class CornerEnd : std::uint8_t {
  LeavesGround,
  LeavesWall,
  SlipsOnGround,
  SlipsOnWall,
  SlipsOnBoth,  // when it rolled on both: on at least one
  GripsGround,
  GripsWall
};

inline constexpr double kHoldingBoth =
    1 / (1 + kSlipRatio);  // friction that rolling takes over A_x, of each

class CornerMotion {
 public:
  /// `path`: in the corner, its `rolling` set.
  CornerMotion(const PathModel& model, const Path& path);

  /// At the start of the path.
  const Cornered& start() const { return start_; }

  /// One step of h seconds by the classical Runge-Kutta method.
  Cornered step(const Cornered& y, double t, double h) const;

  /// The longest step (s) in which friction keeps its direction, and the wall the ball's, well
  /// enough.
  double longestStep(const Cornered& now, double t) const;

  /// > 0 while the motion goes on; <= 0 where it has ended.
  double continuation(const Cornered& now, double t) const {
    return nextEnd(now, t, NoSlip::Begins).margin;
  }

  /// True when nothing can end it.
  bool isEndless() const;

  struct End {
    CornerEnd what;
    double margin;  // m/s^2, or m/s of a slip that ends
  };
  enum class NoSlip : std::uint8_t { Begins, HasEnded };
  /// The nearest end. `noSlip`: what it means where the path starts so and slides.
  End nextEnd(const Cornered& now, double t, NoSlip noSlip) const;

  CornerForces forcesOn(const Cornered& now, double t) const;
  BallState ballOf(const Cornered& now) const;

  /// True where the motion can begin so: friction suffices for what rolls, and does not for what
  /// slides but has no slip yet.
  bool canBegin() const;

  /// True where the wall, which does not press yet, will as the ball gains speed from rest.
  bool beginsToTurn() const;

 private:
  struct Load {
    double pull = 0;      // A_x
    double onWall = 0;    // N_w without friction
    double onGround = 0;  // N_g without friction
    double turning = 0;   // k v, rad/s
  };
  struct Directions {
    Flat wall, ground;  // unit, of the slips
  };
  enum class Small : std::uint8_t { OnWall, OnGround, OnBoth };

  bool rollsOn(std::uint32_t surface) const {
    return path_.rolling == surface || path_.rolling == kCorner;
  }
  Load loadOn(const Cornered& now, double t) const;
  CornerForces forcesOf(const Cornered& now, const Load& load) const;
  Cornered rateOf(const Cornered& now, double t) const;
  Cornered rateUnder(const Cornered& now, const Load& load, const CornerForces& on) const;
  CornerForces rollingForces(const Cornered& now, const Load& load) const;
  CornerForces slidingForces(const Load& load, const Directions& d) const;
  double shareOfWall(const Load& load, double whole) const;
  // In corner_slips.cpp:
  Flat beginningOnWall(const Load& load) const;
  Flat beginningOnGround(const Load& load) const;
  Directions directionsOf(const Cornered& now, const Load& load) const;
  double turnToRates(const Cornered& now, const Load& load, Small small, Directions& d) const;
  double stepFor(Flat slip, Flat rate, double pressing) const;
  double smallSlip(double pressing) const;

  const PathModel& model_;
  const Path& path_;
  Surface surface_;
  Cornered start_;
  double drag_;       // 1/s
  double noise_ = 0;  // m/s, a slip this small is over
  Flat firstOnWall_;  // directions of the slips where they began
  Flat firstOnGround_;
  bool beginsOnBoth_ = false;  // friction suffices for neither
};

}  // namespace wells
