#include "setter.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "errors.h"
#include "settable_keys.h"
#include "setting_checks.h"

namespace wells {
namespace {

// The step from which a setting holds that is set now.
std::int64_t firstStep(const WatchedSession& session) {
  const auto pause = session.settings.registers().find(setting::kPause);
  const bool isOrWillBePaused =
      pause != session.settings.registers().end() && pause->second.value == "true";
  if (isOrWillBePaused) return std::max(session.step, pause->second.fromStep);
  return session.step + Setter::kAhead;
}

// A request for a reset says how many there are to be.
std::string valueToSend(const WantedSetting& wanted, const WatchedSession& session) {
  if (wanted.key != setting::kReset) return wanted.value;
  return std::to_string(std::max(session.generation.resets, resetsAsked(session.settings)) + 1);
}

std::string valueBefore(std::string_view key, const WatchedSession& session) {
  const auto known = session.settings.registers().find(key);
  return known != session.settings.registers().end() ? known->second.value
                                                     : findSettableKey(key)->unset;
}

void requirePeerOf(std::string_view key, const std::vector<PeerId>& peers) {
  const auto well = wellSetting(key);
  if (!well || std::ranges::find(peers, well->peer) != peers.end()) return;
  throw RunError(fmt::format("{}: the session has no peer {}; it has {}", key, value(well->peer),
                             idsText(peers)));
}

// True when a peer that shows `shown` shows what was asked, or a value that came after it.
bool isAtLeast(const Register& shown, const Register& asked) {
  return std::tie(shown.version, shown.setter) >= std::tie(asked.version, asked.setter);
}

}  // namespace

Setter::Setter(Transport& transport, std::vector<WantedSetting> wanted, SettingAuthor author)
    : transport_(transport), wanted_(std::move(wanted)), author_(std::move(author)) {
  author_.name.resize(std::min(author_.name.size(), kMaxSettingAuthor));
}

void Setter::tick(Times now) {
  transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
    finder_.watch().hear(channel, bytes, now);
  });
  if (isOver_) return;
  if (changes_.empty()) {
    if (!finder_.isDone(now.monotonic)) return;
    decide(finder_.session(now.monotonic), now.monotonic);
  }
  look(now.monotonic);
  if (isOver_ || now.monotonic < nextAsk_) return;
  nextAsk_ = now.monotonic + kRepeatInterval;
  ask(now);
}

void Setter::decide(const WatchedSession& session, double now) {
  peers_ = activeIds(session, now);
  SharedSettings after = session.settings;
  std::vector<SettingChange> changes;
  for (const WantedSetting& wanted : wanted_) {
    requirePeerOf(wanted.key, peers_);
    const Register asked = after.next(wanted.key, valueToSend(wanted, session), author_.number,
                                      author_.name, firstStep(session));
    if (!after.learn(wanted.key, asked))
      throw RunError(fmt::format("{}: {} settings are set already, and no more can be", wanted.key,
                                 kMaxSharedSettings));
    changes.push_back(
        {.key = wanted.key, .before = valueBefore(wanted.key, session), .asked = asked});
  }
  changes_ = std::move(changes);
  generation_ = session.generation;
  worldHash_ = session.worldHash;
  step_ = session.step;
  askedAt_ = nextAsk_ = now;
}

void Setter::ask(Times now) {
  for (std::size_t first = 0; first < changes_.size(); first += kMaxSettingsInMessage) {
    const std::size_t end = std::min<std::size_t>(first + kMaxSettingsInMessage, changes_.size());
    gravity_wells::request_t m;
    m.header = {.utime = now.wallUs,
                .protocol = gravity_wells::peer_header_t::PROTOCOL,
                .peer_id = value(kNobody),
                .incarnation = author_.number,
                .sequence = ++sequence_,
                .generation_resets = generation_.resets,
                .generation_founded = generation_.foundedUs,
                .generation_nonce = generation_.nonce,
                .step = step_};
    for (std::size_t i = first; i < end; ++i) {
      const auto& [key, before, r, confirmed, missing, stronger] = changes_[i];
      m.settings.push_back({key, r.value, r.version, r.setter, r.setBy, r.fromStep});
    }
    m.count = static_cast<std::int32_t>(m.settings.size());
    MessageBuffer buffer;
    transport_.publish(channelOf(m), encode(m, buffer));
  }
}

void Setter::look(double now) {
  for (SettingChange& change : changes_) {
    change.confirmed.clear();
    change.missing.clear();
    // A reset founds another generation, to which the peers go one by one.
    for (const WatchedSession& session : finder_.watch().sessions()) {
      if (session.worldHash != worldHash_) continue;
      for (const WatchedPeer* peer : session.peers) {
        if (peer->presence(now) != Presence::Here || std::ranges::count(peers_, peer->id()) == 0)
          continue;
        const auto shown = peer->settings.registers().find(change.key);
        const bool isShown =
            shown != peer->settings.registers().end() && isAtLeast(shown->second, change.asked);
        (isShown ? change.confirmed : change.missing).push_back(peer->id());
        if (isShown && !isAtLeast(change.asked, shown->second)) change.stronger = shown->second;
      }
    }
  }
  for (SettingChange& change : changes_) {
    std::ranges::sort(change.confirmed);
    std::ranges::sort(change.missing);
  }
  isOver_ = isConfirmed() || now >= askedAt_ + kPatience;
}

bool Setter::isConfirmed() const {
  return std::ranges::all_of(changes_, [](const SettingChange& change) {
    return change.missing.empty() && !change.confirmed.empty();
  });
}

std::string changeText(const SettingChange& change) {
  const auto peersText = [](const std::vector<PeerId>& ids) {
    return fmt::format("peer{} {}", ids.size() == 1 ? "" : "s", idsText(ids));
  };
  const Register& asked = change.asked;
  std::string text = change.key == setting::kReset
                         ? fmt::format("Reset: number {}, the world starts over", asked.value)
                         : fmt::format("{}: {} -> {}, from step {}", change.key, change.before,
                                       asked.value, asked.fromStep);
  if (!change.confirmed.empty()) text += ", confirmed by " + peersText(change.confirmed);
  if (!change.missing.empty()) text += ", not confirmed by " + peersText(change.missing);
  if (change.stronger)
    text += fmt::format("; {} has meanwhile set it to {}, and that holds", change.stronger->setBy,
                        change.stronger->value);
  return text;
}

}  // namespace wells
