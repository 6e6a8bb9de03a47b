// How a ball moves that a surface holds: the equations of rolling and sliding in reduced
// coordinates, and one step of the classical Runge-Kutta method through them.
//
// Per mass, in the unrolled surface: F the pull along it, f the friction, N the pressing force, v
// the velocity of the centre, u = v - r w x n the slip, k the curvature along x, s the spin about
// the normal n. Newton and Euler for a solid sphere, I = 2/5 m r^2 (Landau & Lifshitz, Mechanics,
// section 38):
//   v' = F + f,   u' = P + 7/2 f,   P = F + (0, r k v_x s),   s' = k v_x (v_y - u_y) / r,
//   N = k v_x^2 - a . n,  a the fields' acceleration.
// The terms with k are the wall's: its frame turns with the ball, and so does the spin in it.
//   rolling  u = 0:   f = -2/7 P,       while |f| <= mu N
//   sliding  u != 0:  f = -mu N u/|u|
//
// Rolling resistance of lever arm b presses ahead of the contact point: a torque of size b N in the
// tangent plane against the spin there (Johnson, Contact Mechanics, 1985, chapter 9; model A of Ai,
// Chen, Rotter & Ooi, "Assessment of rolling resistance models in discrete element simulations",
// Powder Technology 206 (2011) 269, which lets nothing rest; here it holds as friction does). It is
// a dry friction for the lag c = v - u = r w x n: with t its torque per mass and radius, as f a
// vector along the surface,
//   c' = F - P - 5/2 f + 5/2 t,   u' = P + 7/2 f - 5/2 t,   |t| <= b/r N.
//   rolling   u = 0, c = v:  t = -b/r N v/|v|, f = -2/7 (P - 5/2 t), while |f| <= mu N
//   sliding   u != 0 != c:   f = -mu N u/|u|,  t = -b/r N c/|c|
//   skidding  u != 0, c = 0: f = -mu N u/|u|,  t = f - 2/5 (F - P),  while |t| <= b/r N
//   resting   u = 0 = c:     f = t = -F,       while |F| <= mu N and |F| <= b/r N
// On level ground a rolling ball thus slows down by 5/7 b/r N. Where b > 7/5 mu r it slides; where
// b >= mu r friction cannot make a skidding one turn, and it slides to its rest. The spin about n
// meets no resistance.
#pragma once

#include "contacts/path.h"
#include "contacts/surface.h"

namespace wells {

/// State of a held ball, relative to a Surface.
struct Held {
  Flat place;       // m
  Flat velocity;    // m/s
  Flat slip;        // m/s
  double spin = 0;  // rad/s, about the normal
};

/// Forces per mass (m/s^2) on it, friction left out.
struct Load {
  Flat pull;            // along the surface
  Flat slipPull;        // P: what makes it slip
  double pressing = 0;  // N
};

class HeldMotion {
 public:
  HeldMotion(const PathModel& model, const Path& path);

  /// At the start of the path.
  const Held& start() const { return start_; }

  /// m/s: a slip this small, of the speeds that it is made of, is over. With rolling resistance,
  /// which brings a ball to rest, also of those that it and friction take away in a stretch.
  double noise() const;

  /// One step of h seconds.
  Held step(const Held& y, double t, double h) const;

  /// The longest step (s) in which friction keeps its direction, and the wall the ball's, well
  /// enough.
  double longestStep(const Held& now, double t) const;

  /// > 0 while the motion goes on; <= 0 where it has ended.
  double continuation(const Held& now, double t) const;

  /// Where a motion has ended: true if forces have become too strong for what held the ball's slip
  /// or its turning, false if a slip or a turning has come to its end.
  bool isOverpowered(const Held& now, double t) const;

  /// True when nothing can end it.
  bool isEndless() const;

  Load loadOn(const Held& now, double t) const;
  BallState ballOf(const Held& now) const;

 private:
  struct Rate;

  /// A slip or a turning that dry friction opposes. Both and their rates are velocities along the
  /// surface (m/s, m/s^2).
  struct Opposed {
    Flat first;        // direction in which it began
    double noise = 0;  // m/s, as little of it is over
  };
  /// What acts on one: the pull, and the most that its friction opposes to it.
  struct Drive {
    Flat pull;
    double limit = 0;
  };
  /// Friction along the surface, and what resistance adds to the slip (-5/2 t).
  struct Grip {
    Flat friction;
    Flat resistance;
  };

  Rate rateOf(const Held& now, double t) const;
  Grip gripOn(const Held& now, const Load& load) const;
  Flat lagOf(const Held& now) const;
  Drive driveOfSlip(const Held& now, const Load& load) const;
  Drive driveOfTurning(const Load& load, Flat friction) const;
  double resistanceOnTurning(const Load& load) const;
  double reserve(const Held& now, const Load& load) const;
  double remainder(const Held& now) const;
  double smallest(double limit) const;
  bool follows(double speed, const Drive& drive, const Opposed& opposed) const;
  Flat direction(Flat moving, const Drive& drive, const Opposed& opposed) const;
  double longestStep(Flat moving, const Drive& drive, const Opposed& opposed, double whole) const;
  void beginSlip();
  void beginTurning();

  const PathModel& model_;
  const Path& path_;
  Surface surface_;
  Held start_;
  double drag_;            // 1/s
  double resistance_;      // b / r
  bool isPulled_ = false;  // by anything that may vary or turn
  Opposed slip_;
  Opposed turning_;
};

/// The load on a ball that the path's surface would hold at time t.
Load loadOn(const PathModel& model, const Path& path, double t);

/// Of the path's surface, where the ball is; to the ball.
Vec3 normalOf(const PathModel& model, const Path& path);

/// v - r w x n of a ball that its surface holds, m/s.
Vec3 slipOf(const PathModel& model, const Path& path);

/// m/s: a slip this small, of the speeds that it is made of, is over.
double slipNoise(const BallState& ball, double radius);

/// A motion that turns further than this (rad) round the wall within a step goes in several pieces.
inline constexpr double kLongestArc = 1.0 / 8;

// Of the steps through a slip that turns:
inline constexpr double kTurningShare = 1.0 / 8;      // of the time in which friction ends it
inline constexpr double kFollowingShare = 1.0 / 256;  // of the slip that friction ends in a stretch
inline constexpr double kShortestPart = 1.0 / 256;    // of a stretch: bounds the work
inline constexpr double kBeginning = 1.0 / 64;  // of a stretch, after which it must have begun

inline constexpr double kSpinning = 1 / kInertiaFactor;  // c' over f, 5/2
inline constexpr double kSlipRatio = 1 + kSpinning;      // u' over v' of friction, 7/2
inline constexpr double kHolding = 1 / kSlipRatio;       // friction that rolling takes over P

}  // namespace wells
