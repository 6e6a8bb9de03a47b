// What `gravity-wells peer` is told on its command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config.h"
#include "state/snapshot.h"
#include "thread_places.h"

namespace wells {

/// Steps of a run that only an interrupt ends.
inline constexpr std::int64_t kEndless = std::numeric_limits<std::int64_t>::max();

enum class Company { Session, Solo };

/// Whether the peer id may be given up for a free one when somebody has it already.
enum class IdOrigin { File, CommandLine };

struct PeerOptions {
  Config config;
  IdOrigin idOrigin = IdOrigin::File;
  Company company = Company::Session;
  std::optional<double> duration;  // s, as asked for
  std::int64_t steps = kEndless;   // the world's step at which the run stops
  double targetError = 0;          // m; 0: settings as they are
  std::string engine = "ours";
  ThreadPlaces places;  // of the threads, on this machine
  std::string lcmUrl;   // empty: from UDPPort, staying on this host
  bool requireLcm = false;
  bool quiet = false;
  std::filesystem::path frames;        // a folder; empty: none
  std::filesystem::path video;         // empty: none
  std::filesystem::path lastFrame;     // empty: none
  std::filesystem::path stateOut;      // empty: none
  std::filesystem::path report;        // empty: none
  std::filesystem::path snapshot;      // to be written; empty: none
  bool measures = false;               // keeps books of energy and momentum
  std::optional<double> saveInterval;  // s, as asked for
  std::int64_t snapshotEvery = 0;      // steps; 0: only at the end
  std::optional<Snapshot> restored;    // goes on from this, with its config and engine
  std::vector<std::string> notices;    // about the config file

  bool drawsPictures() const { return !(frames.empty() && video.empty() && lastFrame.empty()); }
  bool hasEnd() const { return steps != kEndless; }
};

/// Parses the arguments behind "peer". Prints the help and returns nothing when that is asked for.
/// Throws UsageError. Looks at files and folders that are named, but starts and writes nothing.
std::optional<PeerOptions> parsePeerOptions(std::span<const std::string> arguments);

/// Makes steps of `duration` and `saveInterval`: again after Dt has changed.
void countSteps(PeerOptions& options);

}  // namespace wells
