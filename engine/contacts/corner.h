// When ground and wall hold a ball at once, and what follows when that ends: which of the motions
// in the corner (corner_motion.h) is possible. One with more rolling goes before one with less.
#pragma once

#include "contacts/path.h"

namespace wells {

/// What holds a ball at path.start that touches ground and wall, and neither leaves nor approaches
/// them: kCorner, or the one that it stays on where friction and forces take it from the other, or
/// kNoSurface where it leaves both or none of the motions fits.
std::uint32_t holderInCorner(const PathModel& model, Path path);

/// Makes such a path, where it is the corner that holds, one of a rolling or sliding ball.
void holdInCorner(const PathModel& model, Path& path);

/// Whatever holds the ball of `path` after its motion in the corner ended at `end`: its surface is
/// set, and in the corner all of it.
Path pathAfterCorner(const PathModel& model, const Path& path, double end);

}  // namespace wells
