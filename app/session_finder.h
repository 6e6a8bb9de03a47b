// Listens to a group until the one session on it is known: its peers, its steps and what is set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session_watch.h"

namespace wells {

class SessionFinder {
 public:
  /// s; each peer sends ten heartbeats a second, of which some may be lost.
  static constexpr double kShortest = 0.5;
  static constexpr double kLongest = 1.5;           // for somebody to be heard
  static constexpr double kSettingsPatience = 3.5;  // for settings, which are sent each second

  SessionWatch& watch() { return watch_; }

  /// True when the session is known, or has not come to be known in time. The first call begins.
  bool isDone(double now);

  /// Throws RunError, which says who was heard instead, when there is none or more than one.
  WatchedSession session(double now) const;

 private:
  SessionWatch watch_;
  std::optional<double> start_;  // s
};

/// "1, 2, 3"
std::string idsText(const std::vector<PeerId>& ids);

/// Those of the active peers.
std::vector<PeerId> activeIds(const WatchedSession& session, double now);

}  // namespace wells
