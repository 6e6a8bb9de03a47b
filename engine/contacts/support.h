// One ball on the ground, in reduced coordinates: where it is pressed down it can only move in the
// plane, with the spin that friction gives it. Height and vertical velocity are exact.
//
// With u = v + w x (-r n) the slip of the contact point, n the normal up, F the pull per mass along
// the ground, N the pressing force per mass (Landau & Lifshitz, Mechanics, section 38; solid
// sphere, I = 2/5 m r^2):
//   rolling  u = 0:   dv/dt = 5/7 F,              friction needed 2/7 |F| <= mu N
//   sliding  u != 0:  dv/dt = F - mu N u/|u|,     du/dt = F - 7/2 mu N u/|u|
// integrated by the classical Runge-Kutta method; what ends a motion is located in time. The spin
// about the normal stays.
#pragma once

#include "contacts/path.h"

namespace wells {

/// u = v + w x (-r n), m/s: how fast the contact point of a ball on the ground slips.
Vec3 slipOnGround(const BallState& ball, double radius);

/// True where the ball of a flying path touches the ground at path.start, neither leaves nor
/// approaches it, and is pressed to it.
bool isHeldByGround(const PathModel& model, const Path& path);

/// Makes such a path one of a rolling or sliding ball.
void holdOnGround(const PathModel& model, Path& path);

/// stateAt() of a rolling or sliding ball.
BallState heldStateAt(const PathModel& model, const Path& path, double t);

/// The first time in (path.start, until] at which a rolling or sliding ball begins to slide, to
/// roll or to lift off, or infinity. What happens and is undone again within one stretch of the
/// field (see Field::stretch) is not seen.
double endOfMotion(const PathModel& model, const Path& path, double until);

/// The path that follows at that time.
Path pathAfter(const PathModel& model, const Path& path, double end);

}  // namespace wells
