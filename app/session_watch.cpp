#include "session_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "network/message_fields.h"

namespace wells {
namespace {

// Of the world we know nothing, so any number of balls may be right.
constexpr DecodeLimits kAnyWorld{.balls = std::numeric_limits<std::int32_t>::max()};

// The others, balls above all, are many and tell nothing of a peer.
constexpr std::string_view kChannels[] = {"WELLS_HEARTBEAT", "WELLS_STATISTICS", "WELLS_SETTINGS",
                                          "WELLS_CONFIG"};

}  // namespace

Generation WatchedPeer::generation() const {
  return generationOf(heartbeat.header);
}

Presence WatchedPeer::presence(double now) const {
  if (phase() == Phase::Leaving) return Presence::Left;
  return now - heardAt <= heartbeat.lease_ms / 1000.0 ? Presence::Here : Presence::Silent;
}

bool WatchedPeer::knows(const SharedSettings& shared) const {
  return std::bit_cast<std::int64_t>(shared.digest()) == heartbeat.settings_digest;
}

std::vector<const WatchedPeer*> WatchedSession::active(double now) const {
  std::vector<const WatchedPeer*> active;
  std::ranges::copy_if(peers, std::back_inserter(active), [&](const WatchedPeer* peer) {
    return peer->phase() == Phase::Active && peer->presence(now) == Presence::Here;
  });
  return active;
}

bool WatchedSession::knowsSettings(double now) const {
  return std::ranges::all_of(active(now), [&](const WatchedPeer* peer) {
    return peer->knows(settings) || peer->knows(peer->settings);
  });
}

void SessionWatch::hear(std::string_view channel, std::span<const std::byte> bytes, Times now) {
  if (std::ranges::find(kChannels, channel) == std::end(kChannels)) return;
  const auto decoded = decode(channel, bytes, kAnyWorld);
  const Message* message = std::get_if<Message>(&decoded);
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { hear(m, now); }) hear(m, now);
      },
      *message);
}

void SessionWatch::hear(const gravity_wells::heartbeat_t& m, Times now) {
  const auto known = peers_.find(m.header.incarnation);
  if (known == peers_.end() && peers_.size() >= kCapacity) return;
  WatchedPeer& peer = known != peers_.end() ? known->second : peers_[m.header.incarnation];
  // What came late is not the latest; a record that is played again begins again.
  const bool isLate = m.header.sequence <= peer.heartbeat.header.sequence;
  if (isLate && peer.presence(now.monotonic) == Presence::Here) return;
  if (generationOf(m.header) != peer.generation()) peer.settings.clear();
  peer.heartbeat = m;
  peer.heardAt = now.monotonic;
  peer.wallOffsetUs = m.header.utime - now.wallUs;
  lastHeard_ = now.monotonic;
}

void SessionWatch::hear(const gravity_wells::statistics_t& m, Times now) {
  WatchedPeer* peer = find(m.header);
  if (!peer) return;
  peer->statistics = m;
  peer->statisticsAt = now.monotonic;
}

void SessionWatch::hear(const gravity_wells::settings_t& m, Times) {
  WatchedPeer* peer = find(m.header);
  if (!peer || generationOf(m.header) != peer->generation()) return;
  for (const auto& s : m.known)
    peer->settings.learn(s.key, {s.value, s.version, s.setter, s.set_by, s.from_step});
}

void SessionWatch::hear(const gravity_wells::world_config_t& m, Times) {
  if (WatchedPeer* peer = find(m.header)) peer->canonical = m.canonical;
}

// Only a heartbeat makes a peer known.
WatchedPeer* SessionWatch::find(const gravity_wells::peer_header_t& header) {
  const auto known = peers_.find(header.incarnation);
  return known == peers_.end() ? nullptr : &known->second;
}

void SessionWatch::forget(double now) {
  std::erase_if(peers_, [&](const auto& entry) { return now - entry.second.heardAt > kMemory; });
}

std::vector<WatchedSession> SessionWatch::sessions() const {
  // Those that were founded stand before those that were not.
  const auto rank = [](const WatchedPeer& peer) {
    const Generation g = peer.generation();
    return std::tuple(!g.exists(), g.foundedUs, g.nonce, g.resets, peer.heartbeat.world_hash);
  };
  std::vector<const WatchedPeer*> all;
  for (const auto& [incarnation, peer] : peers_) all.push_back(&peer);
  std::ranges::stable_sort(
      all, {}, [&](const WatchedPeer* peer) { return std::pair(rank(*peer), peer->id()); });

  std::vector<WatchedSession> sessions;
  for (const WatchedPeer* peer : all) {
    if (sessions.empty() || rank(*sessions.back().peers.front()) != rank(*peer)) {
      sessions.push_back({.worldHash = peer->heartbeat.world_hash,
                          .generation = peer->generation(),
                          .settings = peer->settings});
    }
    WatchedSession& session = sessions.back();
    session.peers.push_back(peer);
    for (const auto& [key, value] : peer->settings.registers()) session.settings.learn(key, value);
    if (!session.canonical) session.canonical = peer->canonical;
    session.step = std::max(session.step, peer->heartbeat.header.step);
  }
  return sessions;
}

std::string generationText(const Generation& generation) {
  return fmt::format("{}-{}-{:016x}", generation.resets, generation.foundedUs,
                     static_cast<std::uint64_t>(generation.nonce));
}

}  // namespace wells
