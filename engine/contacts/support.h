// One ball that the ground, the wall or both hold: where it is pressed to a surface it can only
// move along it, with the spin that friction gives it (held_motion.h, corner_motion.h). Its
// distance from the surface and its velocity towards it are exact; what ends a motion is located in
// time.
#pragma once

#include "contacts/path.h"

namespace wells {

/// A gap this small, of the size of the coordinates, is none for a ball that moves neither to nor
/// from the surface: flight in many stretches leaves it so.
inline constexpr double kHeldGap = 1e-13;

/// What holds the ball of a flying path at path.start: the surface that it touches, neither leaves
/// nor approaches, and is pressed to, or the corner of both (see corner.h).
std::uint32_t holderOf(const PathModel& model, Path path);

/// Makes such a path, with its surface set, one of a held ball.
void holdOn(const PathModel& model, Path& path);

/// stateAt() of a held ball.
BallState heldStateAt(const PathModel& model, const Path& path, double t);

/// The first time in (path.start, until] at which a held ball goes over to another motion or lifts
/// off, or infinity. What happens and is undone again within one stretch of the
/// field (see Field::stretch) is not seen.
double endOfMotion(const PathModel& model, const Path& path, double until);

/// The path that follows at that time.
Path pathAfter(const PathModel& model, const Path& path, double end);

}  // namespace wells
