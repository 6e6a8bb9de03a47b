// How a session goes from phase to phase, and what it does in each.
#include <algorithm>

#include "network/session.h"
#include "network/wells_exchange.h"

namespace wells {
namespace {

constexpr double kConfigPatience = 2;  // s to wait for the config of a foreign world, sent at 1 Hz
constexpr double kAdoptionInterval = 0.05;  // s between two looks for orphans
constexpr std::int64_t kMaxLag = 12;        // steps behind us of a peer that we offer balls to
constexpr std::int64_t kOfferInterval = 6;  // steps between two looks for nearer wells

}  // namespace

Generation Session::greatestHeard(double now) const {
  Generation greatest = generation_;
  for (const Peer* peer : peers_.audible(now))
    if (peer->phase == Phase::Active) greatest = std::max(greatest, peer->generation);
  return greatest;
}

Generation Session::greatestOfOthers(double now) const {
  Generation greatest;
  for (const Peer* peer : peers_.audible(now))
    if (peer->phase == Phase::Active && peer->generation != generation_)
      greatest = std::max(greatest, peer->generation);
  return greatest;
}

void Session::listen(World& world, Times now) {
  if (now.monotonic < listenUntil_) return;
  if (peers_.foreignSenior(startedUs_, self_.number, now.monotonic)) {
    if (now.monotonic < listenUntil_ + kConfigPatience) return;
    throw WorldMismatch("the peers of this group simulate another world");
  }
  if (const Generation greatest = greatestHeard(now.monotonic); greatest.exists()) {
    enter(world, greatest, now);
    return;
  }
  // Of several joiners the first to start founds. If it does not (perhaps it hears somebody whom we
  // don't), it is not waited for without end.
  const auto heard = peers_.audible(now.monotonic);
  const bool isFirst = std::ranges::none_of(
      heard, [&](const Peer* peer) { return peer->startedBefore(startedUs_, self_.number); });
  if (isFirst || now.monotonic >= listenUntil_ + listenTime()) {
    found(world, 0, now);
    note("heard nobody and founded a session");
  }
}

void Session::found(World& world, std::int64_t resets, Times now) {
  generation_ = {.resets = resets,
                 .foundedUs = now.wallUs,
                 .nonce = static_cast<std::int64_t>(random_.bits() >> 1)};
  peers_.setGeneration(generation_);
  world.step = 0;
  balls_.found(world, generation_, self_, now.monotonic);
  removeTracks(world.tracks, [](const WellTrack&) { return true; });
  addOwnTrack(world.tracks, peer(), options_.well, world.step, Appearance::AtOnce);
  shared_.restart();
  nextOffers_ = world.step;
  nextHeartbeat_ = now.monotonic;
  phase_ = Phase::Active;
}

void Session::enter(World& world, const Generation& generation, Times now) {
  if (generation_.exists()) {
    ++counts_.resyncs;
    const bool startsOver = generation.resets > generation_.resets;
    note(generation < generation_ ? "nobody else is left of its session; joins another"
         : startsOver             ? "the world starts over"
                                  : "joins a session that was founded earlier than this one");
  }
  generation_ = generation;
  peers_.setGeneration(generation);
  balls_.enter(world, generation);
  shared_.clear();
  knowsSettings_ = false;
  completeSince_ = now.monotonic;
  hasForgotten_ = false;
  removeTracks(world.tracks, [](const WellTrack&) { return true; });
  world.step = 0;
  lastActiveHeard_ = now.monotonic;
  followGroup(world, now);
  phase_ = Phase::Syncing;
}

void Session::synchronise(World& world, Times now) {
  if (const Generation greatest = greatestHeard(now.monotonic); greatest > generation_) {
    enter(world, greatest, now);
    return;
  }
  followGroup(world, now);
  // Nobody is left of our generation, but there is a lesser one. We have nothing to lose; they
  // have.
  if (const Generation lesser = greatestOfOthers(now.monotonic);
      lesser.exists() && now.monotonic - lastActiveHeard_ > options_.lease) {
    takeIncarnation(peer(), now);
    enter(world, lesser, now);
    return;
  }
  if (trySynchronise(world, now)) {
    activate(world, now);
  } else if (isItsTurnToGoOn(now)) {
    note("everybody else is gone; goes on with " + std::to_string(records().size()) +
         " balls, of which " + std::to_string(balls_.gathering().missing()) +
         " have not been heard of and are where they were first");
    activate(world, now);
    balls_.adoptAll(world, party(), peers_.leases(), now.monotonic);
  }
}

bool Session::isItsTurnToGoOn(Times now) const {
  if (now.monotonic - lastActiveHeard_ <= 2 * options_.lease) return false;
  // Of several who sync the one with the lowest id goes on, and the others hear it.
  const auto living = peers_.living(now.monotonic);
  return std::ranges::none_of(living, [&](const Peer* other) {
    return other->phase == Phase::Syncing && other->who.peer < peer();
  });
}

bool Session::trySynchronise(World& world, Times now) {
  std::vector<Incarnation> active;
  for (const Peer* other : peers_.livingActive(now.monotonic)) active.push_back(other->who);
  if (active.empty() || !knowsSettings_ || !knowsAllWells(world, now) || !balls_.knowsAllOwners()) {
    completeSince_ = now.monotonic;
    return false;
  }
  // The digests of many balls take turns; each has a few chances to be heard.
  constexpr double kRounds = 3;
  const double round = kRounds * digestRound();
  if (balls_.gathering().agrees(active, now.monotonic - options_.lease / 2 - round)) return true;
  if (now.monotonic - completeSince_ <= options_.lease + round) return false;
  if (hasForgotten_) {
    note("knows other owners than the others do, and takes part nevertheless");
    return true;
  }
  // We may be the only one to know something, because its owner was heard by nobody else and is
  // gone. Then it never happened.
  hasForgotten_ = true;
  takeIncarnation(peer(), now);
  forgetOwners(world, now);
  return false;
}

void Session::forgetOwners(World& world, Times now) {
  balls_.forget(world, generation_);
  knowsSettings_ = false;
  completeSince_ = now.monotonic;
}

bool Session::isLowest(Times now) const {
  const auto living = peers_.livingActive(now.monotonic);
  return std::ranges::none_of(living, [&](const Peer* other) { return other->who.peer < peer(); });
}

bool Session::knowsAllWells(const World& world, Times now) const {
  return std::ranges::all_of(peers_.livingActive(now.monotonic), [&](const Peer* other) {
    return std::ranges::count(world.tracks, other->who.peer, &WellTrack::peer) > 0;
  });
}

void Session::followGroup(World& world, Times now) {
  const std::vector<PeerPace> others = paces(now.monotonic);
  const auto front = frontStep(others, paceRule(world), now.monotonic);
  if (!front) return;
  // What the others have done counts; what they have probably done since, only up to our stop.
  const std::int64_t done = std::ranges::max(others, {}, &PeerPace::step).step;
  world.step = std::max({world.step, done, std::min(*front, stopAt_)});
  lastActiveHeard_ = now.monotonic;
}

void Session::activate(World& world, Times now) {
  world.step = std::max(world.step, balls_.gathering().latestStep());
  applySettings(world);
  balls_.activate(world);
  showWell(world);
  nextOffers_ = world.step;
  nextHeartbeat_ =
      now.monotonic;  // the others refuse our states until they know that we are active
  phase_ = Phase::Active;
}

void Session::showWell(World& world) {
  if (std::ranges::find(world.tracks, peer(), &WellTrack::peer) == world.tracks.end())
    addOwnTrack(world.tracks, peer(), options_.well, world.step, Appearance::Delayed);
  extendOwnTrack(world.tracks, peer(), options_.well, world.step);
}

void Session::act(World& world, Times now) {
  if (const Generation greatest = greatestHeard(now.monotonic); greatest > generation_) {
    enter(world, greatest, now);
    return;
  }
  if (const auto asked = resetsAsked(shared_); asked > generation_.resets && isLowest(now)) {
    note("starts the world over");
    found(world, asked, now);
    return;
  }
  tendWells(world, now);
  balls_.applyDue(world, party());
  balls_.closeOffers();
  const bool looksForOrphans = now.monotonic >= nextAdoption_;
  const bool looksForNearer = world.step >= nextOffers_ && !isStopped(world);
  if (!looksForOrphans && !looksForNearer) return;

  const std::vector<PeerWell> wells = livingWells(world, now);
  if (looksForOrphans) {
    balls_.adoptOrphans(world, party(), peers_.leases(), wells, options_.lease, now.monotonic);
    nextAdoption_ = now.monotonic + kAdoptionInterval;
  }
  if (looksForNearer) {
    std::vector<Party> receivers;
    for (const Peer* peer : peers_.livingActive(now.monotonic)) {
      const PeerPace pace{peer->step, peer->stepHeardAt, peer->progress};
      const auto reached = estimatedStep(pace, paceRule(world), now.monotonic);
      // One that lags could not take a ball before it gets to our step.
      if (world.step - reached <= kMaxLag) receivers.push_back({peer->who, peer->phase});
    }
    balls_.offerNearer(world, party(), wells, receivers, options_.handover, now.monotonic);
    nextOffers_ = world.step + kOfferInterval;
  }
}

void Session::tendWells(World& world, Times now) {
  const auto living = peers_.living(now.monotonic);
  const auto isGone = [&](PeerId id) {
    return id != kNobody && id != peer() &&
           std::ranges::none_of(living, [&](const Peer* p) { return p->who.peer == id; });
  };
  // Normally the lowest id names the step. If it does not know that the peer has gone, or has gone
  // itself, the others do so a lease later.
  const double patience = isLowest(now) ? 0 : options_.lease;
  std::vector<PeerId> toSwitchOff;
  for (const WellTrack& track : world.tracks)
    if (isGone(track.peer) && !isSwitchedOff(track) &&
        now.monotonic >= peers_.goneSince(track.peer, now.monotonic) + patience)
      toSwitchOff.push_back(track.peer);
  for (const PeerId id : toSwitchOff) switchOff(world.tracks, id, world.step);
  removeTracks(world.tracks, [&](const WellTrack& track) {
    return isGone(track.peer) && isSwitchedOff(track) &&
           track.keyframes.back().step < world.step - kKeptSteps;
  });
  pruneTracks(world.tracks, world.step);
}

void Session::fenceAfterStall(World& world, Times now) {
  if (phase_ == Phase::Active && lastLoop_ &&
      mustFence(*lastLoop_, now.monotonic, options_.lease)) {
    note("stood still for " + std::to_string(now.monotonic - *lastLoop_) +
         " s, gives up its balls and starts over");
    fence(world, peer(), now);
  }
  lastLoop_ = now.monotonic;
}

void Session::fence(World& world, PeerId newId, Times now) {
  const double lastLoop = lastLoop_.value_or(now.monotonic);
  ++counts_.fences;
  peers_.leases().end(self_, now.monotonic);
  if (newId != peer()) {
    if (phase_ == Phase::Active) switchOff(world.tracks, peer(), world.step);
    // While this incarnation lives, the others refuse an elder one with its id.
    const Phase before = phase_;
    sayGoodBye(world, now);
    phase_ = before;
  }
  takeIncarnation(newId, now);
  if (peers_.heardMemberSince(lastLoop - options_.lease)) {
    forgetOwners(world, now);
    hasForgotten_ = false;
    lastActiveHeard_ = now.monotonic;
    phase_ = Phase::Syncing;
    return;
  }
  // There was nobody who could have taken the balls.
  balls_.drop(world);
  showWell(world);
  balls_.adoptAll(world, party(), peers_.leases(), now.monotonic);
}

void Session::takeIncarnation(PeerId peer, Times now) {
  if (self_.number != 0) formerIncarnations_.push_back(self_.number);
  do {
    self_ = {peer, static_cast<std::int64_t>(random_.bits())};
  } while (self_.number == 0);
  startedUs_ = std::max(startedUs_ + 1, now.wallUs);
  sequence_ = 0;
  nextHeartbeat_ = now.monotonic;
}

}  // namespace wells
