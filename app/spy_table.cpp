#include "spy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace wells {
namespace {

constexpr double kLatePeer = 2;        // s of silence that is worth a line
constexpr double kLateStatistics = 3;  // s after which rates are no longer shown; sent at 1 Hz

std::string clipped(std::string line) {
  if (line.size() > kSpyColumns) line = line.substr(0, kSpyColumns - 3) + "...";
  return line + '\n';
}

// At most five characters: 12.3, 12345, 1234k, 1234M.
std::string compact(double number) {
  if (number != 0 && std::abs(number) < 99.95 && number != std::round(number))
    return fmt::format("{:.1f}", number);
  const char* unit = "";
  for (const char* larger : {"k", "M", "G", "T", "P", "E"}) {
    if (std::abs(number) < (*unit ? 9999.5 : 99999.5)) break;
    number /= 1000;
    unit = larger;
  }
  return fmt::format("{:.0f}{}", number, unit);
}

std::string compact(std::int64_t number) {
  return compact(static_cast<double>(number));
}

std::string small(double number) {
  return number == 0 ? "0" : fmt::format("{:.1e}", number);
}

std::string withSign(std::int64_t number) {
  return fmt::format("{}{}", number > 0 ? "+" : "", compact(number));
}

const gravity_wells::statistics_t* recentStatistics(const WatchedPeer& peer, double now) {
  const bool isRecent = peer.statistics && now - peer.statisticsAt <= kLateStatistics;
  return isRecent ? &*peer.statistics : nullptr;
}

// The worst that other peers say of one.
struct Standing {
  std::int32_t leaseLeftMs = 0;
  std::int32_t clockOffsetMs = 0;
  std::int64_t stepsBehind = 0;
};

std::optional<Standing> standing(const WatchedSession& session, PeerId peer, double now) {
  std::optional<Standing> worst;
  for (const WatchedPeer* other : session.active(now)) {
    const auto* statistics = recentStatistics(*other, now);
    if (!statistics) continue;
    for (const auto& view : statistics->views) {
      if (view.peer_id != value(peer)) continue;
      if (!worst) worst = {view.lease_left_ms, view.clock_offset_ms, view.steps_behind};
      worst->leaseLeftMs = std::min(worst->leaseLeftMs, view.lease_left_ms);
      worst->stepsBehind = std::max(worst->stepsBehind, view.steps_behind);
      if (std::abs(std::int64_t{view.clock_offset_ms}) >
          std::abs(std::int64_t{worst->clockOffsetMs}))
        worst->clockOffsetMs = view.clock_offset_ms;
    }
  }
  return worst;
}

std::string_view phaseText(const WatchedPeer& peer, double now) {
  switch (peer.presence(now)) {
    case Presence::Silent:
      return "silent";
    case Presence::Left:
      return "left";
    case Presence::Here:
      break;
  }
  return name(peer.phase());
}

std::string title(const WatchedSession& session, double now, bool isOneOfSeveral) {
  std::string text =
      session.generation.exists()
          ? fmt::format("Session {}, step {}{}", generationText(session.generation), session.step,
                        isPaused(session.settings, session.step) ? ", paused" : "")
          : "No session yet";
  if (isOneOfSeveral)
    text += fmt::format(", world {:08x}", static_cast<std::uint32_t>(session.worldHash));
  const auto here = std::ranges::count_if(session.peers, [&](const WatchedPeer* peer) {
    return peer->presence(now) == Presence::Here;
  });
  return clipped(fmt::format("{}, {} peer{}", text, here, here == 1 ? "" : "s"));
}

// A row of the two tables, 79 and 76 characters long.
template <class... Cells>
std::string runningRow(const Cells&... cells) {
  return clipped(fmt::format("{:>4} {:<8}{:>7}{:>7}{:>8}{:>7}{:>6}{:>7}{:>7}{:>9}{:>8}", cells...));
}

template <class... Cells>
std::string trafficRow(const Cells&... cells) {
  return clipped(fmt::format("{:>4}{:>7}{:>7}{:>8}{:>7}{:>8}{:>6}{:>7}{:>8}{:>6}{:>8}", cells...));
}

std::string runningTable(const WatchedSession& session, double now) {
  std::string text = runningRow("peer", "phase", "owned", "ghosts", "actual", "target", "lease",
                                "clock", "behind", "doubled", "view");
  text +=
      runningRow("", "", "balls", "balls", "steps/s", "", "s", "ms", "steps", "ball s", "diff m");
  for (const WatchedPeer* peer : session.peers) {
    const auto* s = recentStatistics(*peer, now);
    const auto seen = standing(session, peer->id(), now);
    text += runningRow(
        value(peer->id()), phaseText(*peer, now),
        compact(std::int64_t{s ? s->balls_owned : peer->heartbeat.balls_owned}),
        s ? compact(std::int64_t{s->balls_ghost}) : "-", s ? compact(s->simulation_rate) : "-",
        s ? compact(s->simulation_target) : "-",
        seen ? fmt::format("{:.1f}", seen->leaseLeftMs / 1000.0) : "-",
        seen ? withSign(seen->clockOffsetMs) : "-", seen ? withSign(seen->stepsBehind) : "-",
        s ? compact(s->doubled_ball_seconds) : "-", s ? small(s->view_difference_max) : "-");
  }
  return text;
}

std::string trafficTable(const WatchedSession& session, double now) {
  std::string text = clipped(fmt::format("{:>4}{:^14}{:^15}{:^21}{:^14}{:>8}", "peer", "sent",
                                         "received", "dropped by", "handed over", "adopted"));
  text += trafficRow("", "msgs/s", "kB/s", "msgs/s", "kB/s", "kernel", "queue", "checks", "given",
                     "taken", "balls");
  for (const WatchedPeer* peer : session.peers) {
    const auto* s = recentStatistics(*peer, now);
    if (!s) continue;
    text += trafficRow(
        value(peer->id()), compact(s->messages_sent_rate), compact(s->bytes_sent_rate / 1000),
        compact(s->messages_received_rate), compact(s->bytes_received_rate / 1000),
        compact(s->dropped_by_kernel), compact(s->dropped_in_queue), compact(s->dropped_by_checks),
        compact(s->handovers_given), compact(s->handovers_taken), compact(s->adoptions));
  }
  return text;
}

std::string totals(const WatchedSession& session, double now) {
  std::int64_t owned = 0, balls = 0, peers = 0;
  double messages = 0, bytes = 0;
  for (const WatchedPeer* peer : session.active(now)) {
    const auto* s = recentStatistics(*peer, now);
    if (!s) continue;
    ++peers;
    owned += s->balls_owned;
    balls = std::max<std::int64_t>(balls, s->balls_owned + s->balls_ghost);
    messages += s->messages_sent_rate;
    bytes += s->bytes_sent_rate;
  }
  if (peers == 0) return "";
  return clipped(fmt::format("all   {} of {} balls owned; {} msgs/s, {} kB/s sent", owned, balls,
                             compact(messages), compact(bytes / 1000)));
}

std::string settingsInForce(const WatchedSession& session) {
  std::string text;
  for (const auto& [key, setting] : session.settings.registers()) {
    text += clipped(fmt::format("{} = {}, {} step {}, set by {}", key, setting.value,
                                setting.fromStep <= session.step ? "since" : "from",
                                setting.fromStep, setting.setBy));
  }
  return text.empty() ? "" : "Settings that somebody changed:\n" + text;
}

}  // namespace

std::string spyTable(std::span<const WatchedSession> sessions, double now, double quiet) {
  std::string text;
  for (const WatchedSession& session : sessions) {
    if (!text.empty()) text += '\n';
    text += title(session, now, sessions.size() > 1);
    text += runningTable(session, now);
    text += trafficTable(session, now);
    text += totals(session, now);
    text += settingsInForce(session);
  }
  if (quiet >= kLatePeer || sessions.empty())
    text += fmt::format("no peer heard for {:.0f} s (how to check: ./run.sh peers)\n", quiet);
  return text;
}

}  // namespace wells
