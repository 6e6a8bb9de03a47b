// Changes the shared settings of a live session from outside: listens until it knows the session,
// asks, and asks again until every active peer shows the change. It is no peer: it sends requests
// only. One thread, no clock: the caller passes the time in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "network/transport.h"
#include "session_finder.h"

namespace wells {

struct WantedSetting {
  std::string key;
  std::string value;  // checked: settingFault() has found nothing
};

/// Who asks.
struct SettingAuthor {
  std::int64_t number = 0;  // random, not 0, new for each run
  std::string name;         // for people
};

/// What became of one wanted setting.
struct SettingChange {
  std::string key;
  std::string before;  // what was set last, for people
  Register asked{};
  std::vector<PeerId> confirmed{};     // peers that show it ...
  std::vector<PeerId> missing{};       // ... that don't, of those who were active when we asked
  std::optional<Register> stronger{};  // what somebody else has set meanwhile
};

class Setter {
 public:
  static constexpr double kRepeatInterval = 0.2;  // s between requests
  static constexpr double kPatience = 3;          // s for the peers to confirm
  static constexpr std::int64_t kAhead = 30;      // steps, so that all hear of it before it holds

  /// `transport` must outlive it.
  Setter(Transport& transport, std::vector<WantedSetting> wanted, SettingAuthor author);

  /// Takes what has come and sends what is due. Throws RunError when there is no session, not
  /// the peer whose well is meant, or no more can be set; nothing was sent then.
  void tick(Times now);

  /// All is confirmed, or patience has ended.
  bool isOver() const { return isOver_; }

  /// By then. In the order of `wanted`.
  const std::vector<SettingChange>& changes() const { return changes_; }

  /// Every peer shows all that was asked for, or what somebody else set after it.
  bool isConfirmed() const;

 private:
  void decide(const WatchedSession& session, double now);
  void ask(Times now);
  void look(double now);

  Transport& transport_;
  std::vector<WantedSetting> wanted_;
  SettingAuthor author_;
  SessionFinder finder_;
  std::vector<SettingChange> changes_;  // empty while it listens
  Generation generation_{};
  std::int64_t worldHash_ = 0;
  std::vector<PeerId> peers_;  // that were active
  std::int64_t step_ = 0;
  std::int64_t sequence_ = 0;
  double askedAt_ = 0, nextAsk_ = 0;  // s
  bool isOver_ = false;
};

/// "Gravity: on -> off, from step 1234, confirmed by peers 1, 2, 3"
std::string changeText(const SettingChange& change);

}  // namespace wells
