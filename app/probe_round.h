// Finds out who else is in a multicast group and whether each hears the other: says some times a
// second who it is and whom it hears, and listens. Peers of a session that are live are noticed
// too; they answer nothing. One thread, no clock: the caller passes the time in.
#pragma once

#include <cstdint>
#include <gravity_wells/probe_t.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "math/ids.h"
#include "network/sequence_window.h"
#include "network/session_options.h"
#include "network/transport.h"

namespace wells {

/// Messages of one sender: how many came of how many.
class Reception {
 public:
  /// Counts a sequence number once. True when it is the highest so far.
  bool take(std::int64_t sequence);

  std::int64_t heard() const { return heard_; }
  std::int64_t sent() const { return heard_ > 0 ? window_.highest() - first_ + 1 : 0; }
  std::int64_t latest() const { return window_.highest(); }

 private:
  SequenceWindow window_;
  std::int64_t first_ = 0;
  std::int64_t heard_ = 0;
};

/// Another run of this program.
struct ProbedHost {
  std::string name;
  Reception reception{};
  double latestAt = 0;                              // s, when its latest probe came
  std::optional<gravity_wells::probe_echo_t> us{};  // what it last said of our probes
  std::optional<double> roundTrip{};                // s, the shortest

  bool hearsUs() const { return us && us->heard > 0; }
};

/// A peer of a session.
struct NoticedPeer {
  PeerId id = kNobody;
  Reception reception{};
};

class ProbeRound {
 public:
  static constexpr double kInterval = 0.1;  // s between our probes

  /// `number`: random, not 0, new for each run. `transport` must outlive the round. `host` is cut
  /// to what a probe holds.
  ProbeRound(Transport& transport, std::string host, std::int64_t number);

  /// Takes what has come and sends what is due. Round trips are as fine as calls are frequent.
  void tick(Times now);

  /// By name. The pointers hold until the next tick().
  std::vector<const ProbedHost*> hosts() const;

  /// By id, those of a session last heard.
  std::vector<const NoticedPeer*> peers() const;

 private:
  // Foreign messages must not fill memory.
  static constexpr std::size_t kCapacity = 1024;

  void hearProbe(std::span<const std::byte> bytes, Times now);
  void hearSession(std::string_view channel, std::span<const std::byte> bytes);
  void send(Times now);

  Transport& transport_;
  std::string host_;
  std::int64_t number_;
  double nextProbe_ = 0;                       // s
  std::vector<double> sentAt_;                 // s, by sequence number - 1
  std::int64_t nextEcho_ = 0;                  // number of the run after which echoes go on
  std::map<std::int64_t, ProbedHost> hosts_;   // by number
  std::map<std::int64_t, NoticedPeer> peers_;  // by incarnation
};

}  // namespace wells
