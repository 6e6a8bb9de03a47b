#include "network/session.h"

#include <algorithm>
#include <map>

#include "network/wells_exchange.h"

namespace wells {
namespace {

constexpr double kStepTimeShare = 0.1;  // of the newest in the mean time of a step

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("session: " + what);
}

SessionOptions checked(SessionOptions options) {
  require(value(options.peer) >= 1 && value(options.peer) <= kMaxPeerId,
          "peer is " + std::to_string(value(options.peer)) + "; it must be 1 .. 255");
  require(options.lease >= 0.05 && options.lease <= 60,
          "lease is " + std::to_string(options.lease) + " s; it must be 0.05 .. 60 s");
  require(options.heartbeatRate > 0 && options.stateRate > 0 && options.stepRate > 0,
          "the rates of heartbeats, states and steps must be positive");
  require(options.ballsPerTick >= kMaxBallsInMessage,
          "ballsPerTick is " + std::to_string(options.ballsPerTick) + "; it must be at least 12");
  require(options.canonicalConfig.size() <= kMaxCanonicalBytes,
          "the canonical config has " + std::to_string(options.canonicalConfig.size()) +
              " bytes; it must have at most 1000");
  require(options.well.at && options.predict, "the own well and the predictor must be set");
  return options;
}

}  // namespace

Session::Session(SessionOptions options, World& initial, Transport& transport)
    : options_(checked(std::move(options))),
      transport_(transport),
      random_(options_.seed),
      balls_(initial, options_.predict),
      peers_(options_.worldHash, options_.clockTolerance),
      schedule_(initial.balls.size()),
      worldSettings_(initial.settings) {
  for (WellTrack& track : initial.tracks) track.peer = kNobody;
  initial.roles.assign(initial.balls.size(), Role::Ghost);
}

void Session::beforeStep(World& world, Times now) {
  if (!lastLoop_) {
    takeIncarnation(options_.peer, now);
    listenUntil_ = now.monotonic + listenTime();
  }
  fenceAfterStall(world, now);
  applySettings(world);
  balls_.beginTick();
  transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
    receive(world, channel, bytes, now);
  });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  if (now.monotonic >= nextForget_) {
    peers_.forget(now.monotonic);
    nextForget_ = now.monotonic + 1;
  }
  switch (phase_) {
    case Phase::Joining:
      listen(world, now);
      break;
    case Phase::Syncing:
      synchronise(world, now);
      break;
    case Phase::Active:
      act(world, now);
      break;
    case Phase::Leaving:
      break;
  }
}

int Session::mayStep(const World& world, Times now) {
  isWaiting_ = false;
  if (phase_ != Phase::Active || isStopped(world)) return 0;
  const auto others = paces(now.monotonic);
  const bool isPaused = wells::isPaused(shared_, world.step);
  const int due = isPaused
                      ? stepsDueInPause(world.step, others, paceRule(world))
                      : stepsDue(world.step, stepTime_, others, paceRule(world), now.monotonic);
  isWaiting_ = due == 0;
  return static_cast<int>(std::min<std::int64_t>(due, stopAt_ - world.step));
}

void Session::afterStep(World& world, Times now) {
  const double sinceLastCall = now.monotonic - lastLoop_.value_or(now.monotonic);
  fenceAfterStall(world, now);
  if (phase_ == Phase::Active && world.step != observedStep_) {
    stepTime_ += kStepTimeShare * (sinceLastCall - stepTime_);
    applySettings(world);
    extendOwnTrack(world.tracks, peer(), options_.well, world.step);
    balls_.applyDue(world, party());
    schedule_.observe(world);
    observedStep_ = world.step;
  }
  if (phase_ == Phase::Active) balls_.recordView(world);
  publish(world, now);
}

bool Session::standsStill(const World& world) const {
  return phase_ != Phase::Active || isStopped(world) || isWaiting_;
}

void Session::applySettings(World& world) const {
  const Settings settings = applied(shared_, worldSettings_, world.step);
  world.settings.gravity = settings.gravity;
  world.settings.elasticity = settings.elasticity;
  world.settings.friction = settings.friction;
  world.settings.rollingResistance = settings.rollingResistance;
}

double Session::digestRound() const {
  const std::size_t buckets = bucketCount(records().size());
  const std::size_t heartbeats = (buckets + kMaxBucketsInMessage - 1) / kMaxBucketsInMessage;
  return static_cast<double>(heartbeats) / options_.heartbeatRate;
}

Hearing Session::hearing(const gravity_wells::peer_header_t& header, Times now) {
  return {.now = now.monotonic,
          .apartSince = peers_.apartSince(*peers_.find(header.incarnation), now.monotonic),
          .patience = options_.lease / 2};
}

bool Session::isComplete(const World& world) const {
  return phase_ == Phase::Active && isStopped(world) && balls_.isComplete(world);
}

bool Session::areOthersComplete(Times now) const {
  return std::ranges::all_of(peers_.livingActive(now.monotonic), &Peer::complete);
}

std::vector<std::pair<PeerId, std::size_t>> Session::ballsOwned() const {
  std::map<PeerId, std::size_t> owned;
  for (const Record& record : records()) ++owned[record.version.owner.peer];
  return {owned.begin(), owned.end()};
}

std::vector<PeerId> Session::livingPeers(Times now) const {
  std::vector<PeerId> ids;
  for (const Peer* peer : peers_.livingActive(now.monotonic)) ids.push_back(peer->who.peer);
  if (phase_ == Phase::Active) ids.push_back(self_.peer);
  std::ranges::sort(ids);
  return ids;
}

SessionCounts Session::counts() const {
  SessionCounts counts = counts_;
  counts.balls = balls_.counts();
  return counts;
}

std::vector<PeerPace> Session::paces(double now) const {
  std::vector<PeerPace> paces;
  for (const Peer* peer : peers_.livingActive(now))
    paces.push_back({peer->step, peer->stepHeardAt, peer->progress});
  return paces;
}

std::vector<PeerWell> Session::livingWells(const World& world, Times now) const {
  std::vector<PeerWell> wells = peerWells(world);
  const std::vector<PeerId> living = livingPeers(now);
  std::erase_if(
      wells, [&](const PeerWell& well) { return !std::ranges::binary_search(living, well.peer); });
  return wells;
}

void Session::note(const std::string& text) const {
  if (options_.notice) options_.notice("peer " + std::to_string(value(peer())) + ": " + text);
}

}  // namespace wells
