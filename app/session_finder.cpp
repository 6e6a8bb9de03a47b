#include "session_finder.h"

#include <fmt/format.h>

#include <algorithm>

#include "errors.h"
#include "values.h"

namespace wells {
namespace {

std::vector<WatchedSession> activeSessions(const SessionWatch& watch, double now) {
  std::vector<WatchedSession> sessions = watch.sessions();
  std::erase_if(sessions, [&](const WatchedSession& s) { return s.active(now).empty(); });
  return sessions;
}

std::string severalText(const std::vector<WatchedSession>& sessions, double now) {
  std::string text = fmt::format("{} sessions are on this group:", sessions.size());
  for (const WatchedSession& session : sessions)
    text += fmt::format(" {} of world {:08x} with peers {};", generationText(session.generation),
                        static_cast<std::uint32_t>(session.worldHash),
                        idsText(activeIds(session, now)));
  const bool isOneWorld = std::ranges::all_of(sessions, [&](const WatchedSession& session) {
    return session.worldHash == sessions.front().worldHash;
  });
  return text + (isOneWorld ? " they become one in some seconds"
                            : " give each world a port of its own (UDPPort, --lcm-url)");
}

std::string nobodyText(const SessionWatch& watch, double now) {
  std::vector<PeerId> waiting;
  for (const WatchedSession& session : watch.sessions())
    for (const WatchedPeer* peer : session.peers)
      if (peer->presence(now) == Presence::Here) waiting.push_back(peer->id());
  if (waiting.empty())
    return "no session: no peer was heard; ./run.sh peers tells whether multicast passes";
  return fmt::format("no session yet: peer{} {} joining; try again in some seconds",
                     waiting.size() == 1 ? "" : "s",
                     idsText(waiting) + (waiting.size() == 1 ? " is" : " are"));
}

}  // namespace

bool SessionFinder::isDone(double now) {
  if (!start_) start_ = now;
  const double listened = now - *start_;
  if (listened < kShortest) return false;
  const auto sessions = activeSessions(watch_, now);
  if (sessions.empty()) return listened >= kLongest;
  const bool areKnown = std::ranges::all_of(
      sessions, [&](const WatchedSession& session) { return session.knowsSettings(now); });
  return areKnown || listened >= kSettingsPatience;
}

WatchedSession SessionFinder::session(double now) const {
  const auto sessions = activeSessions(watch_, now);
  if (sessions.empty()) throw RunError(nobodyText(watch_, now));
  if (sessions.size() > 1) throw RunError(severalText(sessions, now));
  return sessions.front();
}

std::string idsText(const std::vector<PeerId>& ids) {
  std::vector<std::string> texts;
  for (const PeerId id : ids) texts.push_back(std::to_string(value(id)));
  return joined(texts, ", ");
}

std::vector<PeerId> activeIds(const WatchedSession& session, double now) {
  std::vector<PeerId> ids;
  for (const WatchedPeer* peer : session.active(now)) ids.push_back(peer->id());
  return ids;
}

}  // namespace wells
