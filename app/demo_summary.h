// What the demonstration's peers wrote, read again and told as a table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wells {

/// The files of one peer.
struct PeerFiles {
  std::filesystem::path report;
  std::filesystem::path state;
  std::filesystem::path video;
  std::filesystem::path lastFrame;
  std::filesystem::path log;  // what it said
};

/// The files peer-<id>.* in a folder.
PeerFiles peerFiles(const std::filesystem::path& folder, int id);

/// Throws RunError when a report cannot be understood, and UsageError when a state file cannot.
std::string demoSummary(const std::vector<PeerFiles>& peers);

}  // namespace wells
