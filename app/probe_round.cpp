#include "probe_round.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "probe_message.h"

namespace wells {

bool Reception::take(std::int64_t sequence) {
  const bool isLatest = sequence > window_.highest();
  if (heard_ == 0) first_ = sequence;
  if (sequence >= first_ && window_.accept(sequence)) ++heard_;
  return isLatest;
}

ProbeRound::ProbeRound(Transport& transport, std::string host, std::int64_t number)
    : transport_(transport), host_(std::move(host)), number_(number) {
  host_.resize(std::min(host_.size(), kMaxHostName));
}

void ProbeRound::tick(Times now) {
  transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
    if (channel == kProbeChannel) {
      hearProbe(bytes, now);
    } else {
      hearSession(channel, bytes);
    }
  });
  if (now.monotonic < nextProbe_) return;
  nextProbe_ = now.monotonic + kInterval;
  send(now);
}

void ProbeRound::hearProbe(std::span<const std::byte> bytes, Times now) {
  const auto probe = decodeProbe(bytes);
  if (!probe || probe->header.incarnation == number_) return;
  const auto known = hosts_.find(probe->header.incarnation);
  if (known == hosts_.end() && hosts_.size() >= kCapacity) return;
  ProbedHost& host = known != hosts_.end() ? known->second : hosts_[probe->header.incarnation];
  if (!host.reception.take(probe->header.sequence)) return;
  host.name = probe->host;
  host.latestAt = now.monotonic;
  for (const auto& echo : probe->echoes) {
    if (echo.incarnation != number_) continue;
    host.us = echo;
    if (echo.latest < 1 || echo.latest > static_cast<std::int64_t>(sentAt_.size())) continue;
    const double sent = sentAt_[static_cast<std::size_t>(echo.latest - 1)];
    const double held = static_cast<double>(echo.held_us) / 1e6;
    const double roundTrip = std::max(0.0, now.monotonic - sent - held);
    host.roundTrip = std::min(host.roundTrip.value_or(roundTrip), roundTrip);
  }
}

void ProbeRound::hearSession(std::string_view channel, std::span<const std::byte> bytes) {
  const auto decoded = decode(channel, bytes, {.balls = std::numeric_limits<std::int32_t>::max()});
  const Message* message = std::get_if<Message>(&decoded);
  if (!message || headerOf(*message).peer_id == 0) return;
  const auto& header = headerOf(*message);
  const auto known = peers_.find(header.incarnation);
  if (known == peers_.end() && peers_.size() >= kCapacity) return;
  NoticedPeer& peer = known != peers_.end() ? known->second : peers_[header.incarnation];
  peer.id = PeerId{header.peer_id};
  peer.reception.take(header.sequence);
}

void ProbeRound::send(Times now) {
  gravity_wells::probe_t probe{};
  sentAt_.push_back(now.monotonic);
  probe.header.utime = now.wallUs;
  probe.header.protocol = gravity_wells::peer_header_t::PROTOCOL;
  probe.header.incarnation = number_;
  probe.header.sequence = static_cast<std::int64_t>(sentAt_.size());
  probe.host = host_;
  auto next = hosts_.upper_bound(nextEcho_);
  for (std::size_t i = 0; i < std::min<std::size_t>(hosts_.size(), kMaxEchoesInMessage); ++i) {
    if (next == hosts_.end()) next = hosts_.begin();
    const auto& [number, host] = *next;
    const double held = now.monotonic - host.latestAt;
    probe.echoes.push_back({number, host.reception.heard(), host.reception.sent(),
                            host.reception.latest(), std::llround(held * 1e6)});
    nextEcho_ = number;
    ++next;
  }
  probe.count = static_cast<std::int32_t>(probe.echoes.size());
  MessageBuffer buffer;
  transport_.publish(kProbeChannel, encodeProbe(probe, buffer));
}

std::vector<const ProbedHost*> ProbeRound::hosts() const {
  std::vector<const ProbedHost*> hosts;
  for (const auto& [number, host] : hosts_) hosts.push_back(&host);
  std::ranges::stable_sort(hosts, {}, [](const ProbedHost* host) { return host->name; });
  return hosts;
}

std::vector<const NoticedPeer*> ProbeRound::peers() const {
  std::vector<const NoticedPeer*> peers;
  for (const auto& [incarnation, peer] : peers_) peers.push_back(&peer);
  std::ranges::stable_sort(peers, {}, &NoticedPeer::id);
  return peers;
}

}  // namespace wells
