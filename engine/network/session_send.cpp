// What a session sends, and when.
#include <algorithm>
#include <bit>
#include <cmath>

#include "network/message_fields.h"
#include "network/session.h"
#include "network/wells_exchange.h"

namespace wells {
namespace {

constexpr double kWellInterval = 0.05;    // s; every keyframe is repeated until it is long past
constexpr double kSettingsInterval = 1;   // s
constexpr double kKnown = 0.5;            // s for which an owner is known before a digest counts it
constexpr double kOfferInterval = 0.1;    // s between repetitions of an offer
constexpr double kStoppedInterval = 0.2;  // s between repetitions of the states of a stopped world
constexpr int kFarewells = 3;             // good-byes, since any may be lost

gravity_wells::bucket_digest_t digestMessage(const BucketDigest& digest) {
  gravity_wells::bucket_digest_t message{};
  for (std::size_t i = 0; i < kBallsInBucket; ++i)
    if (digest.known[i]) message.known[i / 8] |= static_cast<std::uint8_t>(1u << (i % 8));
  message.sum = std::bit_cast<std::int64_t>(digest.sum);
  return message;
}

bool isDue(double& next, double interval, double now) {
  if (now < next) return false;
  next = now - next > interval ? now + interval : next + interval;  // what was missed stays missed
  return true;
}

}  // namespace

void Session::publish(World& world, Times now) {
  if (phase_ == Phase::Leaving) return;
  const double t = now.monotonic;
  if (isDue(nextHeartbeat_, 1 / options_.heartbeatRate, t)) sendHeartbeat(world, now);
  if (isDue(nextConfig_, 1, t)) sendConfig(world, now);
  if (phase_ == Phase::Syncing && isDue(nextSettings_, kSettingsInterval, t))
    sendSettings(world, now);
  if (phase_ != Phase::Active) return;
  // First what somebody waits for: a receiver with a full buffer hears the beginning only.
  sendOffers(world, now);
  if (isDue(nextSettings_, kSettingsInterval, t)) sendSettings(world, now);
  if (isDue(nextWell_, kWellInterval, t)) sendWells(world, now);
  if (isDue(nextStates_, 1 / options_.stateRate, t)) {
    StatePace pace{.moving = 1 / options_.stateRate, .limit = options_.ballsPerTick};
    if (isStopped(world)) pace.moving = pace.resting = kStoppedInterval;
    if (wells::isPaused(shared_, world.step)) pace.moving = pace.resting;
    sendStates(world, schedule_.pick(world, pace, t), now);
  }
  if (isDue(nextStatistics_, 1, t)) sendStatistics(world, now);
}

void Session::leave(World& world, Times now) {
  if (phase_ == Phase::Leaving) return;
  if (phase_ == Phase::Active) {
    // No more than the receivers' buffers hold; of the rest they have predictions.
    const StatePace pace{.moving = 0, .resting = 0, .limit = 2 * options_.ballsPerTick};
    sendStates(world, schedule_.pick(world, pace, now.monotonic), now);
    sendHeartbeat(world, now);  // with the last digests
  }
  sayGoodBye(world, now);
}

void Session::sayGoodBye(const World& world, Times now) {
  phase_ = Phase::Leaving;
  for (int i = 0; i < kFarewells; ++i) sendHeartbeat(world, now);
}

gravity_wells::peer_header_t Session::header(const World& world, Times now) {
  return {.utime = now.wallUs,
          .protocol = gravity_wells::peer_header_t::PROTOCOL,
          .peer_id = value(peer()),
          .incarnation = self_.number,
          .sequence = ++sequence_,
          .generation_resets = generation_.resets,
          .generation_founded = generation_.foundedUs,
          .generation_nonce = generation_.nonce,
          .step = world.step};
}

void Session::send(const Message& message) {
  MessageBuffer buffer;
  const auto bytes = encode(message, buffer);
  transport_.publish(std::visit([](const auto& m) { return channelOf(m); }, message), bytes);
}

void Session::sendHeartbeat(const World& world, Times now) {
  gravity_wells::heartbeat_t m;
  m.header = header(world, now);
  m.started = startedUs_;
  m.world_hash = options_.worldHash;
  m.phase = static_cast<std::int32_t>(phase_);
  m.paused = standsStill(world);
  m.complete = isComplete(world);
  m.lease_ms = static_cast<std::int32_t>(std::lround(options_.lease * 1000));
  m.balls_owned = static_cast<std::int32_t>(ballsOwnedHere());
  m.settings_digest = std::bit_cast<std::int64_t>(shared_.digest());
  addDigests(m, now);
  send(m);
}

void Session::addDigests(gravity_wells::heartbeat_t& m, Times now) {
  const std::size_t buckets = bucketCount(records().size());
  m.first_bucket = 0;
  m.buckets = 0;
  if (phase_ != Phase::Active && phase_ != Phase::Syncing) return;
  // At the end of a run nothing changes hands any more.
  const double known = now.monotonic - (m.complete ? 0 : kKnown);
  if (nextBucket_ >= buckets) nextBucket_ = 0;
  const std::size_t end = std::min<std::size_t>(nextBucket_ + kMaxBucketsInMessage, buckets);
  m.first_bucket = static_cast<std::int32_t>(nextBucket_);
  for (; nextBucket_ < end; ++nextBucket_)
    m.digests.push_back(digestMessage(balls_.digest(nextBucket_, phase_, known)));
  m.buckets = static_cast<std::int32_t>(m.digests.size());
}

void Session::sendSettings(const World& world, Times now) {
  const auto& registers = shared_.registers();
  for (auto next = registers.begin(); next != registers.end();) {
    gravity_wells::settings_t m;
    m.header = header(world, now);
    for (; next != registers.end() && m.known.size() < kMaxSettingsInMessage; ++next) {
      const auto& [key, r] = *next;
      m.known.push_back({key, r.value, r.version, r.setter, r.setBy, r.fromStep});
    }
    m.count = static_cast<std::int32_t>(m.known.size());
    send(m);
  }
}

void Session::sendConfig(const World& world, Times now) {
  gravity_wells::world_config_t m;
  m.header = header(world, now);
  m.world_hash = options_.worldHash;
  m.canonical = options_.canonicalConfig;
  send(m);
}

void Session::sendWells(const World& world, Times now) {
  const bool speaksForTheGone = isLowest(now);
  const std::vector<PeerId> living = livingPeers(now);
  for (const WellTrack& track : world.tracks) {
    const bool isGone = track.peer != kNobody && isSwitchedOff(track) &&
                        !std::ranges::binary_search(living, track.peer);
    if (track.peer != peer() && !(isGone && speaksForTheGone)) continue;
    gravity_wells::wells_t m = wellMessage(world.tracks, track.peer);
    m.header = header(world, now);
    send(m);
  }
}

void Session::sendStates(const World& world, const std::vector<std::uint32_t>& chosen, Times now) {
  for (std::size_t first = 0; first < chosen.size(); first += kMaxBallsInMessage) {
    const std::size_t end = std::min<std::size_t>(first + kMaxBallsInMessage, chosen.size());
    gravity_wells::ball_states_t m;
    m.header = header(world, now);
    m.step = world.step;
    for (std::size_t i = first; i < end; ++i) {
      const std::uint32_t ball = chosen[i];
      m.balls.push_back(
          ballMessage(ball, balls_.publish(world, ball, party()), world.balls.state(ball)));
    }
    m.count = static_cast<std::int32_t>(m.balls.size());
    send(m);
  }
}

void Session::sendOffers(const World& world, Times now) {
  balls_.closeOffers();
  std::vector<OpenOffer*> due;
  for (OpenOffer& open : balls_.openOffers()) {
    if (now.monotonic < open.nextSend) continue;
    open.nextSend = now.monotonic + kOfferInterval;
    due.push_back(&open);
  }
  // A message has one receiver and one step.
  const auto shares = [](const OpenOffer* a, const OpenOffer* b) {
    return a->version.owner == b->version.owner && a->version.step == b->version.step;
  };
  std::ranges::stable_sort(due, {}, [](const OpenOffer* open) {
    return std::pair(open->version.owner, open->version.step);
  });
  for (std::size_t first = 0; first < due.size();) {
    const Version& version = due[first]->version;
    gravity_wells::offers_t m;
    m.header = header(world, now);
    m.receiver = value(version.owner.peer);
    m.receiver_incarnation = version.owner.number;
    m.step = version.step;
    std::size_t next = first;
    for (; next < due.size() && next - first < kMaxBallsInMessage && shares(due[first], due[next]);
         ++next)
      m.balls.push_back(ballMessage(due[next]->ball, due[next]->version, due[next]->state));
    m.count = static_cast<std::int32_t>(m.balls.size());
    send(m);
    first = next;
  }
}

}  // namespace wells
