// What a session does with what it receives. Whatever is refused here changes nothing.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "network/message_fields.h"
#include "network/session.h"
#include "network/wells_exchange.h"
#include "network/world_difference.h"

namespace wells {
namespace {

// Heartbeats heard from another peer with our id before we believe in it. A message of our own
// predecessor that is still under way must not drive us out.
constexpr int kHeartbeatsToBelieve = 3;

constexpr double kClockPatience = 1;  // s

// s. An owner answers a digest that is not its own no sooner than so long after it last sent a
// ball.
constexpr double kAnswerInterval = 0.25;

// s of steps. What changed hands longer ago than an owner takes to be counted in digests, and some
// more for lost states, is not recent.
constexpr double kRecent = 0.8;

// s until the shared settings are sent again to somebody who does not know them.
constexpr double kSettingsPatience = 0.1;

BucketDigest digestOf(const gravity_wells::bucket_digest_t& message) {
  BucketDigest digest;
  for (std::size_t i = 0; i < kBallsInBucket; ++i)
    digest.known[i] = ((message.known[i / 8] >> (i % 8)) & 1) != 0;
  digest.sum = std::bit_cast<std::uint64_t>(message.sum);
  return digest;
}

std::string describe(const Peer& peer) {
  return "peer " + std::to_string(value(peer.who.peer));
}

}  // namespace

void Session::receive(World& world, std::string_view channel, std::span<const std::byte> bytes,
                      Times now) {
  if (channel == kProbeChannel) return;  // somebody asks whether multicast passes
  const auto decoded =
      decode(channel, bytes, {.balls = static_cast<std::int64_t>(records().size())});
  const Message* message = std::get_if<Message>(&decoded);
  const auto drop = message ? heed(world, *message, now) : std::get<Drop>(decoded);
  if (drop) {
    counts_.drops.add(*drop);
  } else {
    ++counts_.accepted;
  }
}

std::optional<Drop> Session::heed(World& world, const Message& message, Times now) {
  const std::int64_t sender = headerOf(message).incarnation;
  if (sender == self_.number || std::ranges::count(formerIncarnations_, sender) > 0)
    return Drop::Echo;
  return std::visit([&](const auto& m) { return hear(world, m, now); }, message);
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::heartbeat_t& m, Times now) {
  if (const auto drop = peers_.hear(m, now)) {
    if (*drop == Drop::ClockApart) noteClock(m.header, now);
    return drop;
  }
  const Peer& other = *peers_.find(m.header.incarnation);
  if (other.who.peer == peer()) return settleId(world, other, now);
  const bool isForeign = other.generation.exists() && other.generation != generation_;
  if (isForeign && phase_ != Phase::Joining) return Drop::ForeignGeneration;
  if (other.generation == generation_) hearDigests(world, other, m, now);
  return std::nullopt;
}

void Session::hearDigests(const World& world, const Peer& other,
                          const gravity_wells::heartbeat_t& m, Times now) {
  if (other.phase != Phase::Active && other.phase != Phase::Syncing) return;
  const bool theirsCount = other.phase == Phase::Active;
  const auto recent = m.header.step - std::llround(kRecent * stepRate(world));
  const bool sameSettings = m.settings_digest == std::bit_cast<std::int64_t>(shared_.digest());
  if (phase_ == Phase::Syncing && theirsCount && sameSettings) knowsSettings_ = true;
  if (!sameSettings) nextSettings_ = std::min(nextSettings_, now.monotonic + kSettingsPatience);
  for (std::int32_t i = 0; i < m.buckets; ++i) {
    const auto bucket = static_cast<std::size_t>(m.first_bucket + i);
    const BucketDigest theirs = digestOf(m.digests[static_cast<std::size_t>(i)]);
    if (phase_ == Phase::Syncing && theirsCount)
      balls_.hearDigest(other.who, bucket, theirs, recent, peers_.leases(), now.monotonic);
    if (phase_ != Phase::Active) continue;
    for (const std::uint32_t ball : balls_.wanted(bucket, theirs, other.phase, self_))
      schedule_.want(ball, now.monotonic - kAnswerInterval);
  }
}

std::optional<Drop> Session::settleId(World& world, const Peer& other, Times now) {
  if (other.heartbeats < kHeartbeatsToBelieve || other.isOver) return Drop::DuplicateId;
  const bool otherJoins = other.phase == Phase::Joining;
  const bool weJoin = phase_ == Phase::Joining;
  bool weYield = other.startedBefore(startedUs_, self_.number);
  if (weJoin != otherJoins) {
    weYield = weJoin;
  } else if (!weJoin && other.generation != generation_) {
    weYield = other.generation > generation_;
  }
  if (weYield) giveUpId(world, now);
  return Drop::DuplicateId;
}

void Session::giveUpId(World& world, Times now) {
  const std::string taken = "peer id " + std::to_string(value(peer())) +
                            " is in use by a peer that has been here for longer";
  const PeerId free = peers_.lowestFreeId(now.monotonic);
  if (options_.idChoice == PeerIdChoice::Explicit || free == kNobody) {
    error_ = std::make_exception_ptr(
        PeerIdTaken(taken + (free == kNobody ? ", and so is every other up to 255"
                                             : "; choose another, or leave the choice to us")));
    return;
  }
  note(taken + "; takes id " + std::to_string(value(free)) + " instead");
  if (phase_ == Phase::Joining) {
    takeIncarnation(free, now);
    listenUntil_ = std::max(listenUntil_, now.monotonic + options_.lease);
  } else {
    fence(world, free, now);
  }
}

std::optional<Drop> Session::checkMember(const gravity_wells::peer_header_t& header, Times now) {
  if (const auto drop = peers_.hear(header, now)) return drop;
  if (phase_ == Phase::Joining) return Drop::NotJoined;
  if (header.peer_id == value(peer())) return Drop::DuplicateId;
  if (generationOf(header) != generation_) return Drop::ForeignGeneration;
  if (peers_.find(header.incarnation)->phase != Phase::Active) return Drop::NotActive;
  return std::nullopt;
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::wells_t& m, Times now) {
  if (const auto drop = checkMember(m.header, now)) return drop;
  // What we computed with an older idea of a well, the others predict otherwise.
  if (learnTrack(world.tracks, m, world.step) == TrackNews::Late) schedule_.wantAll();
  return std::nullopt;
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::ball_states_t& m, Times now) {
  if (const auto drop = checkMember(m.header, now)) return drop;
  const Incarnation owner{PeerId{m.header.peer_id}, m.header.incarnation};
  std::optional<Drop> refused;
  for (const auto& ball : m.balls) {
    const BallNews news{static_cast<std::size_t>(ball.id), versionOf(m.header, ball, owner, m.step),
                        stateOf(ball)};
    const auto drop = phase_ == Phase::Active
                          ? balls_.hearState(world, news, hearing(m.header, now))
                          : balls_.gather(world, news, Standing::Heard, hearing(m.header, now));
    if (drop) refused = drop;
  }
  return refused;
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::offers_t& m, Times now) {
  if (const auto drop = checkMember(m.header, now)) return drop;
  const Incarnation receiver{PeerId{m.receiver}, m.receiver_incarnation};
  std::optional<Drop> refused;
  for (const auto& ball : m.balls) {
    const BallNews news{static_cast<std::size_t>(ball.id),
                        versionOf(m.header, ball, receiver, m.step), stateOf(ball)};
    std::optional<Drop> drop;
    if (news.version.epoch == 0) {
      drop = Drop::ImpossibleVersion;  // an offer always begins an epoch
    } else if (phase_ == Phase::Active) {
      drop = balls_.hearOffer(world, news, party(), hearing(m.header, now));
    } else {
      drop = balls_.gather(world, news, Standing::Named, hearing(m.header, now));
    }
    if (drop) refused = drop;
  }
  return refused;
}

std::optional<Drop> Session::hear(World&, const gravity_wells::world_config_t& m, Times now) {
  const auto drop = peers_.hear(m.header, now);
  if (drop == Drop::ForeignWorld) noteForeignWorld(*peers_.find(m.header.incarnation), m.canonical);
  return drop;
}

void Session::noteForeignWorld(Peer& other, const std::string& canonical) {
  if (other.isNoted) return;
  other.isNoted = true;
  const std::string text =
      describe(other) + " simulates another world: " +
      describeDifference(canonical, options_.canonicalConfig, options_.defaultOf);
  const bool isSenior =
      other.phase != Phase::Joining || other.startedBefore(startedUs_, self_.number);
  if (phase_ == Phase::Joining && isSenior) {
    error_ = std::make_exception_ptr(WorldMismatch(text));
  } else {
    note(text + "; it is ignored");
  }
}

void Session::noteClock(const gravity_wells::peer_header_t& header, Times now) {
  // After a stall of our own, what has waited for us is old, and no clock is wrong.
  if (!clockApartSince_) clockApartSince_ = now.monotonic;
  if (now.monotonic - *clockApartSince_ < kClockPatience || clockIsNoted_) return;
  clockIsNoted_ = true;
  const std::int64_t ahead = (header.utime - now.wallUs) / 1'000'000;
  note("the wall clock of peer " + std::to_string(header.peer_id) + " is " +
       std::to_string(std::abs(ahead)) + " s " + (ahead > 0 ? "ahead of" : "behind") +
       " ours; it is ignored until both show the same time");
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::settings_t& m, Times now) {
  // One who syncs may be the only one left that knows them.
  if (const auto drop = checkMember(m.header, now); drop && drop != Drop::NotActive) return drop;
  return learn(world, m.known, now);
}

std::optional<Drop> Session::hear(World& world, const gravity_wells::request_t& m, Times now) {
  if (const auto drop = peers_.checkClock(m.header, now)) return drop;
  if (phase_ != Phase::Active) return Drop::NotJoined;
  if (generationOf(m.header) != generation_) return Drop::ForeignGeneration;
  return learn(world, m.settings, now);
}

std::optional<Drop> Session::learn(World& world,
                                   const std::vector<gravity_wells::setting_t>& settings,
                                   Times now) {
  std::optional<Drop> refused;
  for (const auto& s : settings) {
    auto wrong = checkSessionSetting(s.key, s.value);
    if (wrong && options_.checkSetting) wrong = options_.checkSetting(s.key, s.value);
    if (wrong) {
      refused = Drop::OutOfRange;
    } else if (shared_.learn(s.key, {s.value, s.version, s.setter, s.set_by, s.from_step})) {
      nextSettings_ = now.monotonic;
      if (phase_ == Phase::Active) note(s.set_by + " sets " + s.key + " to " + s.value);
    }
  }
  applySettings(world);
  return refused;
}

std::optional<Drop> Session::hear(World&, const gravity_wells::statistics_t& m, Times now) {
  return peers_.hear(m.header, now);
}

}  // namespace wells
