// What must hold of a snapshot before an engine may go on from it.
#pragma once

#include "state/snapshot.h"

namespace wells {

/// Throws SnapshotError with the field, its value and what is allowed.
void requireValid(const Snapshot& snapshot);

}  // namespace wells
