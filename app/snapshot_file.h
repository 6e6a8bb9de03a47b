// Snapshots in files: what --save-snapshot writes and --restore reads.
#pragma once

#include <filesystem>

#include "state/snapshot.h"

namespace wells {

/// Whatever happens, `file` holds its old content or the whole new snapshot. Throws RunError.
void writeSnapshot(const std::filesystem::path& file, const Snapshot& snapshot);

/// Throws UsageError with the file and what is wrong with it.
Snapshot readSnapshot(const std::filesystem::path& file);

}  // namespace wells
