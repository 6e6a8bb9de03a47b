// What a program that is no peer learns by listening to a group: the sessions on it, their peers
// and what these say of themselves. It answers nothing and decides nothing; clocks and replayed
// messages are not checked, so that a record played back can be watched too.
#pragma once

#include <cstdint>
#include <gravity_wells/heartbeat_t.hpp>
#include <gravity_wells/statistics_t.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "network/codec.h"
#include "network/session_options.h"
#include "network/shared_settings.h"
#include "ownership/phase.h"
#include "ownership/version.h"

namespace wells {

enum class Presence {
  Here,    // heard within its lease
  Silent,  // not heard for a lease
  Left,    // said good-bye
};

/// One incarnation of a peer.
struct WatchedPeer {
  gravity_wells::heartbeat_t heartbeat{};  // the latest
  double heardAt = 0;                      // s, when it came
  std::int64_t wallOffsetUs = 0;           // its wall clock minus ours then; journey included
  std::optional<gravity_wells::statistics_t> statistics{};  // the latest
  double statisticsAt = 0;                                  // s
  SharedSettings settings{};                                // that it has shown
  std::optional<std::string> canonical{};                   // its world's config

  PeerId id() const { return PeerId{heartbeat.header.peer_id}; }
  Phase phase() const { return static_cast<Phase>(heartbeat.phase); }
  Generation generation() const;
  Presence presence(double now) const;

  /// True when `settings` hold what it knows, by the digest of its heartbeat.
  bool knows(const SharedSettings& shared) const;
};

/// Peers of one world in one generation. Joiners of a world that has none yet make up one, too.
struct WatchedSession {
  std::int64_t worldHash = 0;
  Generation generation{};
  std::vector<const WatchedPeer*> peers{};  // by id
  SharedSettings settings{};                // that any of them has shown
  std::optional<std::string> canonical{};   // the world's config: KEY=VALUE lines without defaults
  std::int64_t step = 0;                    // the greatest

  /// Those who are here and active.
  std::vector<const WatchedPeer*> active(double now) const;

  /// True when all that any active peer knows was heard.
  bool knowsSettings(double now) const;
};

class SessionWatch {
 public:
  /// Of a group that other programs use too, anything may come: what is not well formed is ignored.
  void hear(std::string_view channel, std::span<const std::byte> bytes, Times now);

  /// Drops who has not been heard for kMemory.
  void forget(double now);

  /// In order of founding, each with at least one peer; joiners without a generation last. The
  /// pointers hold until the next hear() or forget().
  std::vector<WatchedSession> sessions() const;

  /// s when any peer was last heard; nothing: never.
  std::optional<double> lastHeard() const { return lastHeard_; }

  static constexpr double kMemory = 30;  // s

 private:
  // Incarnations; more are ignored. Foreign messages must not fill memory.
  static constexpr std::size_t kCapacity = 1024;

  void hear(const gravity_wells::heartbeat_t& m, Times now);
  void hear(const gravity_wells::statistics_t& m, Times now);
  void hear(const gravity_wells::settings_t& m, Times now);
  void hear(const gravity_wells::world_config_t& m, Times now);
  WatchedPeer* find(const gravity_wells::peer_header_t& header);

  std::map<std::int64_t, WatchedPeer> peers_;  // by incarnation number
  std::optional<double> lastHeard_;
};

/// "0-1700000000000000-00000000000000ff", as in reports.
std::string generationText(const Generation& generation);

}  // namespace wells
