// How strongly wells may pull a ball in the next moments.
#pragma once

#include "forces/field.h"

namespace wells {

/// Bound (m/s^2) on the pull of all wells on a ball that is at `position` (m) at time t (s since
/// the start of the step), during the next `duration` seconds, in which it moves no faster than
/// `speed` (m/s). A well pulls most at softening / sqrt(2) from it: further away ever less, and
/// nearer ever less.
double pullBound(const Field& field, const Vec3& position, double speed, double t, double duration);

}  // namespace wells
