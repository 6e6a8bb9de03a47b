// Config keys that are of no common kind: places of things, files, wells and paths.
#pragma once

#include "keys.h"
#include "values.h"

namespace wells {

/// m^3/s^2 of a well.
inline const Range kStrength = Range::between(-1e15, 1e15);
/// m of a well. Below the smallest no step of use is short enough.
inline const Range kSoftening = Range::between(0.01, 1e6);

Key arenaCenterKey();
Key ballsFileKey();
Key wellKey();
Key wellPathKey();
Key integratorKey();
Key contactMethodKey();
Key broadphaseKey();
Key hostIpKey();

}  // namespace wells
