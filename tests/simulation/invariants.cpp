#include "simulation/invariants.h"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/describe.h"
#include "simulation/toy_world.h"

namespace wells::simulation {
namespace {

// A state that is older is taken as if it were only so old: SharedBalls::kMaxPredicted.
constexpr std::int64_t kMaxPredicted = 300;  // steps

// Leases that who founds must have listened for, on a clock that may run slow.
constexpr double kListening = 1.99;

bool areEqual(const BallState& a, const BallState& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin;
}

/// Says again what Generation's order says.
bool goesBefore(const Generation& a, const Generation& b) {
  if (a.resets != b.resets) return a.resets > b.resets;
  if (a.foundedUs != b.foundedUs) return a.foundedUs < b.foundedUs;
  return a.nonce > b.nonce;
}

bool isOff(const WellTrack& track, std::int64_t step) {
  return wellAt(track, step, 1).strength == 0;
}

bool areEqual(const WellTrack& a, const WellTrack& b, std::int64_t step) {
  const Well first = wellAt(a, step, 1), second = wellAt(b, step, 1);
  return first.position == second.position && first.strength == second.strength;
}

}  // namespace

void Invariants::report(Invariant invariant, double now, std::string what) {
  violations_.push_back({invariant, now, std::move(what)});
}

void Invariants::claim(std::size_t ball, const Version& version, double now) {
  if (version.owner == Incarnation{}) return;
  const auto [known, isNew] = owners_[ball].try_emplace(tenureOf(version), version.owner);
  if (known->second == version.owner) return;
  report(Invariant::OneOwnerEver, now,
         fmt::format("ball {} is {}'s and {}'s in the tenure {}", ball, describe(known->second),
                     describe(version.owner), describe(version)));
}

void Invariants::tell(std::size_t ball, const Version& version, const BallState& state,
                      double now) {
  const auto [known, isNew] = states_[ball].try_emplace(version, state);
  if (!isNew && !areEqual(known->second, state))
    report(Invariant::StatesFit, now,
           fmt::format("ball {} has two states of {}", ball, describe(version)));
}

void Invariants::checkChange(const Process& process, const PeerView& peer, double now) {
  const bool hasFounded = !process.generation.exists() && peer.phase == Phase::Active;
  if (hasFounded && now - *process.born < kListening * lease_)
    report(Invariant::FoundersListen, now,
           fmt::format("{} founds a session {:.2f} s after its start", describe(peer.self),
                       now - *process.born));
  if (process.phase != Phase::Active) return;
  if (peer.generation != process.generation && !goesBefore(peer.generation, process.generation))
    report(Invariant::OlderLasts, now,
           fmt::format("{} goes from {} to {}", describe(peer.self), describe(process.generation),
                       describe(peer.generation)));
  if (peer.phase == Phase::Active && peer.self == process.self && now - process.seen > lease_)
    report(Invariant::SilentGiveUp, now,
           fmt::format("{} stood still for {:.2f} s and goes on", describe(peer.self),
                       now - process.seen));
}

void Invariants::checkSettings(Process& process, const PeerView& peer, double now) {
  if (!peer.registers) return;
  for (const auto& [key, value] : *peer.registers) {
    auto& known = process.settings[key];
    const std::pair version{value.version, value.setter};
    if (version < known)
      report(Invariant::VersionsRise, now,
             fmt::format("{}: {} goes from version {} back to {}", describe(peer.self), key,
                         known.first, version.first));
    known = version;
  }
}

void Invariants::checkGhosts(Process& process, const PeerView& peer, double now) {
  if (peer.phase != Phase::Active) return;
  static const World kAnyWorld;  // toyPredict takes one
  for (std::size_t i = 0; i < balls_; ++i) {
    const Version& version = peer.records[i].version;
    if (peer.owns(i) || version.step > peer.step) continue;  // of a step to come: waits for it
    Course& course = process.courses[i];
    if (course.version != version || course.step < 0) {
      const auto told = states_[i].find(version);
      const bool isKnown = told != states_[i].end() && peer.step - version.step <= kMaxPredicted;
      course = {version, isKnown ? version.step : -1, isKnown ? told->second : BallState{}};
    }
    if (course.step < 0) continue;
    course.state = toyPredict(kAnyWorld, i, course.state, course.step, peer.step);
    course.step = peer.step;
    if (areEqual(course.state, peer.balls->state(i))) continue;
    report(Invariant::StatesFit, now,
           fmt::format("{}, ball {}: is not where the state leads of {}", describe(peer.self), i,
                       describe(version)));
  }
}

void Invariants::observe(const PeerView& peer, double now,
                         const std::function<bool(const Incarnation&)>& wasHeard) {
  const auto complain = [&](Invariant invariant, std::size_t ball, const std::string& what) {
    report(invariant, now, fmt::format("{}, ball {}: {}", describe(peer.self), ball, what));
  };
  if (peer.records.size() != balls_ || peer.roles.size() != balls_ || peer.balls->size() != balls_)
    return complain(Invariant::Complete, balls_, "is not the last of all");

  for (std::size_t i = 0; i < balls_; ++i) {
    if (!isFinite(peer.balls->state(i))) complain(Invariant::Complete, i, "is not finite");
    const bool isOver = peer.phase == Phase::Leaving;  // its world is nobody's concern any more
    if (!isOver && (peer.roles[i] == Role::Owned) != peer.owns(i))
      complain(Invariant::RolesMatch, i,
               fmt::format("is {} in the world; {}, {}",
                           peer.roles[i] == Role::Owned ? "owned" : "a ghost", name(peer.phase),
                           describe(peer.records[i])));
  }
  Process& process = processes_[peer.process];
  if (!process.born) process.born = now;
  if (!peer.generation.exists()) return;
  checkChange(process, peer, now);
  process.phase = peer.phase;
  process.seen = now;
  process.courses.resize(balls_);
  checkGhosts(process, peer, now);
  const bool isAnew =
      process.self != peer.self || process.generation != peer.generation || process.records.empty();
  if (isAnew) {
    process.self = peer.self;
    process.generation = peer.generation;
    process.records.assign(peer.records.begin(), peer.records.end());
    process.history.assign(balls_, {});
    process.settings.clear();
    for (std::size_t i = 0; i < balls_; ++i) learn(process, peer, i, now);
    return;
  }
  checkSettings(process, peer, now);
  for (std::size_t i = 0; i < balls_; ++i) {
    const Record& before = process.records[i];
    const Record& after = peer.records[i];
    if (after == before) continue;
    if (after.version < before.version ||
        (after.version == before.version && after.standing < before.standing))
      complain(Invariant::VersionsRise, i, describe(before) + " became " + describe(after));
    const bool isAdopted = after.version.term > before.version.term &&
                           after.version.adopter == peer.self && after.version.epoch == 0;
    if (isAdopted && areAll(i, before.version, after.version, wasHeard))
      complain(Invariant::LivingKeepTheirs, i, "is adopted from " + describe(before));
    if (!sameTenure(before.version, after.version) || before.version.owner != after.version.owner)
      learn(process, peer, i, now);
    process.records[i] = after;
  }
}

bool Invariants::areAll(std::size_t ball, const Version& from, const Version& to,
                        const std::function<bool(const Incarnation&)>& heard) const {
  const auto& owners = owners_[ball];
  const auto end = owners.lower_bound(tenureOf(to));
  return std::all_of(owners.lower_bound(tenureOf(from)), end,
                     [&](const auto& tenure) { return heard(tenure.second); });
}

void Invariants::learn(Process& process, const PeerView& peer, std::size_t ball, double now) {
  claim(ball, peer.records[ball].version, now);
  std::vector<Known>& known = process.history[ball];
  known.push_back({now, peer.records[ball].version});
  while (known.size() > 1 && known[1].time <= now - 1) known.erase(known.begin());
}

Version Invariants::knownFor(int process, std::size_t ball, double seconds, double now) const {
  Version version{};
  const auto place = processes_.find(process);
  if (place == processes_.end()) return version;
  for (const Known& known : place->second.history[ball])
    if (known.time <= now - seconds) version = known.version;
  return version;
}

void Invariants::joined(const PeerView& joiner, std::span<const int> others, double now) {
  for (const int other : others) {
    const PeerId id = processes_[other].self.peer;
    if (std::ranges::count(*joiner.tracks, id, &WellTrack::peer) == 0)
      report(Invariant::WellsAgree, now,
             fmt::format("{} becomes active without the well of peer {}", describe(joiner.self),
                         value(id)));
  }
  for (std::size_t i = 0; i < balls_; ++i) {
    for (const int other : others) {
      Version known = knownFor(other, i, 1, now);
      if (known.generation != joiner.generation) continue;
      const Version& own = joiner.records[i].version;
      known.step = own.step;
      if (own < known)
        report(
            Invariant::JoinersKnow, now,
            fmt::format("{}, ball {}: becomes active with {}, while process {} has long known {}",
                        describe(joiner.self), i, describe(own), other, describe(known)));
    }
  }
}

void Invariants::group(std::span<const PeerView> peers, double now) {
  for (std::size_t i = 0; i < balls_; ++i) {
    int owners = 0;
    const PeerView* latest = &peers.front();
    for (const PeerView& peer : peers) {
      if (peer.owns(i)) ++owners;
      if (peer.records[i].version > latest->records[i].version) latest = &peer;
    }
    if (owners == 1) {
      unowned_.erase({peers.front().self, i});
      continue;
    }
    const auto complain = [&](Invariant invariant, const std::string& what) {
      std::string text = fmt::format("ball {} {}:", i, what);
      for (const PeerView& peer : peers)
        text += fmt::format(" {} knows {};", describe(peer.self), describe(peer.records[i]));
      report(invariant, now, text);
    };
    if (owners > 1) {
      complain(Invariant::OneActsAsOwner, fmt::format("has {} owners", owners));
      continue;
    }
    const Version& version = latest->records[i].version;
    const auto named = std::ranges::find(peers, version.owner, &PeerView::self);
    if (named == peers.end()) {
      complain(Invariant::OneActsAsOwner, "has no owner, and nobody here is named");
      continue;
    }
    // One that lags knows of it and waits for its own step.
    if (named->records[i].version == version && version.step > named->step) continue;
    if (named->losesMessages) continue;
    Unowned& unowned = unowned_[{peers.front().self, i}];
    if (now - unowned.seen > lease_ / 2) unowned.since = now;
    unowned.seen = now;
    if (now - unowned.since > 2 * lease_) {
      complain(Invariant::NobodyForLong, "has been named, but not taken, for two leases");
      unowned.since = now;
    }
  }
}

void Invariants::healed(std::span<const PeerView> peers, double now) {
  std::vector<PeerView> active;
  for (const PeerView& peer : peers)
    if (peer.phase == Phase::Active) active.push_back(peer);
  if (active.empty()) return;
  for (const PeerView& peer : active)
    if (peer.generation != active.front().generation)
      report(Invariant::Heals, now,
             fmt::format("{} and {} are active in two generations", describe(active.front().self),
                         describe(peer.self)));
  const std::size_t before = violations_.size();
  group(active, now);
  for (std::size_t i = before; i < violations_.size(); ++i)
    violations_[i].invariant = Invariant::Heals;
}

void Invariants::complete(std::span<const PeerView> peers, double now) {
  for (const PeerView& peer : peers) {
    const PeerView& first = peers.front();
    if (peer.settings != first.settings)
      report(Invariant::Agree, now,
             fmt::format("{} and {} know different shared settings", describe(first.self),
                         describe(peer.self)));
    for (std::size_t i = 0; i < balls_; ++i) {
      const BallState a = first.balls->state(i);
      const BallState b = peer.balls->state(i);
      const bool isEqual = areEqual(a, b);
      if (isEqual && first.records[i].version == peer.records[i].version) continue;
      report(Invariant::Agree, now,
             fmt::format("ball {}: {} knows {}, {} knows {}; their states {}", i,
                         describe(first.self), describe(first.records[i]), describe(peer.self),
                         describe(peer.records[i]), isEqual ? "are equal" : "differ"));
    }
    for (const WellTrack& track : *peer.tracks) {
      const bool isThere =
          std::ranges::any_of(peers, [&](const PeerView& p) { return p.self.peer == track.peer; });
      const auto same = std::ranges::find(*first.tracks, track.peer, &WellTrack::peer);
      const bool isEqual = isThere
                               ? same != first.tracks->end() && areEqual(*same, track, peer.step)
                               : isOff(track, peer.step);
      if (isEqual) continue;
      report(Invariant::WellsAgree, now,
             fmt::format("{} has the well of peer {} {}", describe(peer.self), value(track.peer),
                         isThere ? "elsewhere than the others" : "on, who is gone"));
    }
  }
}

}  // namespace wells::simulation
