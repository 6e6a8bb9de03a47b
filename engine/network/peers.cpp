#include "network/peers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "network/message_fields.h"

namespace wells {
namespace {

// Of a lease, between two heartbeats that count: a record played back at once is only one.
constexpr double kApart = 1.0 / 50;

bool isMember(const Peer& peer, const Generation& generation) {
  return !peer.isOver && peer.world == WorldMatch::Same && generation.exists() &&
         peer.generation == generation &&
         (peer.phase == Phase::Syncing || peer.phase == Phase::Active);
}

}  // namespace

void Peers::setGeneration(const Generation& generation) {
  generation_ = generation;
  leases_.clear();
  for (const auto& [number, peer] : peers_)
    if (isMember(peer, generation_)) leases_.expect(peer.who, peer.lease, peer.heardAt);
}

std::optional<Drop> Peers::checkClock(const gravity_wells::peer_header_t& header, Times now) const {
  const double apart = std::abs(static_cast<double>(header.utime - now.wallUs)) * 1e-6;
  if (apart > clockTolerance_) return Drop::ClockApart;
  return std::nullopt;
}

std::optional<Drop> Peers::hear(const gravity_wells::heartbeat_t& heartbeat, Times now) {
  const auto& header = heartbeat.header;
  if (const auto drop = checkClock(header, now)) return drop;
  const Incarnation who{PeerId{header.peer_id}, header.incarnation};
  if (!peers_.contains(who.number) && peers_.size() >= kCapacity) return Drop::UnknownSender;
  Peer& peer = peers_.try_emplace(who.number, Peer{.who = who}).first->second;
  if (peer.who != who) return Drop::UnknownSender;
  if (peer.isOver) return Drop::DeadSender;
  if (!peer.sequences.accept(header.sequence)) return Drop::Replayed;

  noteHeard(peer, now.monotonic);
  peer.clockOffset = static_cast<double>(header.utime - now.wallUs) * 1e-6;
  if (peer.heartbeats == 0 || now.monotonic - peer.countedAt >= kApart * peer.lease) {
    peer.heartbeats = std::min(peer.heartbeats + 1, 1000);
    peer.countedAt = now.monotonic;
  }
  // One that was overtaken by a later one tells an old phase.
  if (header.sequence < peer.newestHeartbeat) return std::nullopt;
  peer.newestHeartbeat = header.sequence;

  if (peer.generation != generationOf(header)) peer.step = 0;
  peer.startedUs = heartbeat.started;
  peer.generation = generationOf(header);
  peer.phase = static_cast<Phase>(heartbeat.phase);
  peer.progress = heartbeat.paused ? Progress::Paused : Progress::Running;
  peer.complete = heartbeat.complete;
  peer.world = heartbeat.world_hash == worldHash_ ? WorldMatch::Same : WorldMatch::Foreign;
  peer.lease = heartbeat.lease_ms * 1e-3;
  if (peer.world == WorldMatch::Foreign) return Drop::ForeignWorld;
  if (peer.phase == Phase::Leaving) {
    leases_.end(who, now.monotonic);
    peer.isOver = true;
    return std::nullopt;
  }
  if (isReplaced(peer, now.monotonic)) return Drop::DeadSender;
  if (isMember(peer, generation_)) leases_.supersede(who, now.monotonic);
  renew(peer, header.step, now.monotonic);
  return std::nullopt;
}

std::optional<Drop> Peers::hear(const gravity_wells::peer_header_t& header, Times now) {
  if (const auto drop = checkClock(header, now)) return drop;
  Peer* peer = find(header.incarnation);
  if (!peer || value(peer->who.peer) != header.peer_id) return Drop::UnknownSender;
  if (peer->isOver) return Drop::DeadSender;
  if (!peer->sequences.accept(header.sequence)) return Drop::Replayed;
  if (peer->world == WorldMatch::Foreign) return Drop::ForeignWorld;
  if (isReplaced(*peer, now.monotonic)) return Drop::DeadSender;
  noteHeard(*peer, now.monotonic);
  if (generationOf(header) == peer->generation) renew(*peer, header.step, now.monotonic);
  return std::nullopt;
}

bool Peers::isReplaced(const Peer& peer, double now) const {
  if (!isMember(peer, generation_) || leases_.isLiving(peer.who, now)) return false;
  return std::ranges::any_of(peers_, [&](const auto& entry) {
    const Peer& other = entry.second;
    return other.who.peer == peer.who.peer && other.who != peer.who &&
           isMember(other, generation_) && leases_.isLiving(other.who, now) &&
           peer.startedBefore(other.startedUs, other.who.number);
  });
}

void Peers::renew(Peer& peer, std::int64_t step, double now) {
  if (step >= peer.step) {
    peer.step = step;
    peer.stepHeardAt = now;
  }
  if (isMember(peer, generation_)) leases_.hear(peer.who, step, peer.progress, peer.lease, now);
}

void Peers::noteHeard(Peer& peer, double now) {
  if (peer.heartbeats > 0 && now - peer.heardAt > peer.lease) {
    peer.lostAt = peer.heardAt + peer.lease;
    peer.foundAt = now;
  }
  peer.heardAt = now;
}

double Peers::apartSince(const Peer& peer, double now) const {
  return now - peer.foundAt <= 2 * peer.lease ? peer.lostAt : now;
}

Peer* Peers::find(std::int64_t incarnation) {
  const auto entry = peers_.find(incarnation);
  return entry == peers_.end() ? nullptr : &entry->second;
}

std::vector<const Peer*> Peers::living(double now) const {
  std::vector<const Peer*> members;
  for (const auto& [number, peer] : peers_)
    if (isMember(peer, generation_) && leases_.isLiving(peer.who, now)) members.push_back(&peer);
  return members;
}

std::vector<const Peer*> Peers::members() const {
  std::vector<const Peer*> members;
  for (const auto& [number, peer] : peers_)
    if (isMember(peer, generation_)) members.push_back(&peer);
  std::ranges::sort(members, {}, [](const Peer* peer) { return peer->who; });
  return members;
}

double Peers::goneSince(PeerId id, double now) const {
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& [number, peer] : peers_)
    if (peer.who.peer == id)
      if (const auto ended = leases_.endedAt(peer.who, now)) last = std::max(last, *ended);
  return last;
}

std::vector<const Peer*> Peers::livingActive(double now) const {
  std::vector<const Peer*> members = living(now);
  std::erase_if(members, [](const Peer* peer) { return peer->phase != Phase::Active; });
  return members;
}

std::vector<const Peer*> Peers::audible(double now) const {
  std::vector<const Peer*> heard;
  for (const auto& [number, peer] : peers_)
    if (!peer.isOver && peer.world == WorldMatch::Same && now - peer.heardAt < peer.lease)
      heard.push_back(&peer);
  return heard;
}

const Peer* Peers::foreignSenior(std::int64_t ourStartedUs, std::int64_t ourIncarnation,
                                 double now) const {
  for (const auto& [number, peer] : peers_) {
    const bool isAudible = !peer.isOver && now - peer.heardAt < peer.lease;
    if (peer.world == WorldMatch::Foreign && isAudible &&
        (peer.phase != Phase::Joining || peer.startedBefore(ourStartedUs, ourIncarnation)))
      return &peer;
  }
  return nullptr;
}

bool Peers::heardMemberSince(double time) const {
  return std::ranges::any_of(peers_, [&](const auto& entry) {
    return isMember(entry.second, generation_) && entry.second.heardAt >= time;
  });
}

PeerId Peers::lowestFreeId(double now) const {
  const auto heard = audible(now);
  for (std::int32_t id = 1; id <= kMaxPeerId; ++id)
    if (std::ranges::none_of(heard, [&](const Peer* p) { return value(p->who.peer) == id; }))
      return PeerId{id};
  return kNobody;
}

void Peers::forget(double now) {
  // The clocks of sender and receiver may each be off by the tolerance.
  const double time = now - 2 * clockTolerance_ - 1;
  std::erase_if(peers_, [&](const auto& entry) { return entry.second.heardAt < time; });
  leases_.forget(time, now);
}

}  // namespace wells
