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

  /// One step of h seconds.
  Held step(const Held& y, double t, double h) const;

  /// The longest step (s) in which friction keeps its direction, and the wall the ball's, well
  /// enough.
  double longestStep(const Held& now, double t) const;

  /// > 0 while the motion goes on; <= 0 where it has ended.
  double continuation(const Held& now, double t) const;

  /// True when nothing can end it.
  bool isEndless() const;

  Load loadOn(const Held& now, double t) const;
  BallState ballOf(const Held& now) const;

 private:
  struct Rate;

  Rate rateOf(const Held& now, double t) const;
  double frictionOnSlip(const Load& load) const;
  double smallSlip(double friction) const;
  Flat direction(Flat slip, const Load& load) const;

  const PathModel& model_;
  const Path& path_;
  Surface surface_;
  Held start_;
  double drag_;            // 1/s
  double noise_ = 0;       // m/s, a slip this small is over
  bool isPulled_ = false;  // by anything that may vary or turn
  Flat first_;             // direction of the slip where it began
};

/// The load on a ball that the path's surface would hold at time t.
Load loadOn(const PathModel& model, const Path& path, double t);

/// True when friction suffices to roll.
bool canRoll(const PathModel& model, const Load& load);

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
inline constexpr double kShortestStep = 1.0 / 256;    // of a stretch: bounds the work
inline constexpr double kBeginning = 1.0 / 64;  // of a stretch, after which it must have begun

inline constexpr double kSlipRatio = 1 + 1 / kInertiaFactor;  // u' over v' of friction, 7/2

}  // namespace wells
