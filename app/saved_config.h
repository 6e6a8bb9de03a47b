// The part of a Config that a run needs to go on from a snapshot: the keys of the world, and those
// of this peer's well, which may move. All others may change from run to run.
#pragma once

#include <filesystem>
#include <span>

#include "config.h"
#include "config_file.h"
#include "state/snapshot.h"

namespace wells {

/// Those keys with their values. Files are named from the root, so that they are found from any
/// folder.
std::vector<std::pair<std::string, std::string>> savedConfig(const Config& config);

/// The config that a snapshot was saved with, all other keys at their defaults. `file` is the
/// snapshot's, for messages. Throws UsageError.
Config restoredConfig(const Snapshot& snapshot, const std::filesystem::path& file);

/// `config` is what a restored one became by `settings`. Throws UsageError unless they left the
/// saved part as it was.
void requireAsSaved(const Snapshot& snapshot, const Config& config,
                    std::span<const Setting> settings);

}  // namespace wells
