// When does a ball hit something? The first time at which a gap closes, on the path itself.
//
// A gap is followed from the left: from a time t at which it is open, step by the longest time in
// which a lower bound of the gap stays positive, and look again. With gap g, closing speed c and a
// bound A on how fast the closing speed can grow, g(t + s) >= g - c s - A s^2 / 2 for balls and
// ground (the distance of two points in uniform motion is convex), so
//   s = 2 g / (c + sqrt(c^2 + 2 A g)).
// Where A = 0, or at the ground under gravity alone, one step lands on the contact; in general the
// steps converge quadratically, as Newton's method does, but never jump over a contact.
// (Conservative advancement: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems",
// 1996, section 2.3.) The wall is followed in R^2 - rho^2, rho the distance from the axis, which is
// a parabola in uniform motion.
#pragma once

#include <cstdint>

#include "contacts/path.h"

namespace wells {

enum class Meeting : std::uint8_t {
  None,      // the gap stays open until the end
  Impact,    // closes at `time`
  Sustained  // touches and is pressed together: no instant describes it
};

struct Encounter {
  Meeting meeting = Meeting::None;
  double time = 0;  // s since the start of the step; of an impact
};

/// The first encounter of two balls between `from` and `until`; both paths start at or before
/// `from`. A pair that touches at `from` and separates is followed to its next encounter.
Encounter encounterOfBalls(const PathModel& model, const Path& a, const Path& b, double from,
                           double until);

/// The first encounter of a ball with the ground (kGround) or the wall (kWall). None with
/// the surface that holds it.
Encounter encounterWithArena(const PathModel& model, const Path& ball, std::uint32_t partner,
                             double from, double until);

/// A ball of whose flight nothing is known but where it starts and that nothing besides gravity
/// pulls it by more than `pull` (m/s^2, its accelerationBound).
struct Flyer {
  const Path* path;
  double pull;
};

/// True where two balls cannot meet between `from` (no earlier than their paths start) and `until`:
/// then a search would find nothing, and they need not be followed.
bool stayApart(const PathModel& model, const Flyer& a, const Flyer& b, double from, double until);

/// m, a lower bound on its gap at time t to a ball that is then at `position`.
double leastGap(const PathModel& model, const Flyer& ball, double t, const Vec3& position,
                double radius);

/// As stayApart(), of a ball and the ground (kGround) or the wall (kWall) from the start of its
/// path on.
bool staysOff(const PathModel& model, const Flyer& ball, std::uint32_t partner, double until);

}  // namespace wells
