// Which motion a ball goes over to that the ground or the wall holds; the conditions are those of
// held_motion.h.
#pragma once

#include "contacts/held_motion.h"

namespace wells {

/// Of a path whose ball is held from path.start on by path.surface; `arriving` is made of it.
Motion motionOf(const PathModel& model, const Path& path, const HeldMotion& arriving);

/// Of a ball whose grip has ended (HeldMotion::isOverpowered) on `path`, under the load at that
/// time.
Motion motionWithoutGrip(const PathModel& model, const Path& path, const Load& load);

}  // namespace wells
