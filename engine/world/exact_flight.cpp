#include "world/exact_flight.h"

#include <algorithm>
#include <utility>

#include "contacts/held_motion.h"
#include "contacts/impacts.h"
#include "contacts/support.h"
#include "math/room.h"

namespace wells {
namespace {

constexpr std::size_t kMostKept = 4096;  // balls of an island that others go on with

// Gaps up to this (m), times the size of the coordinates, belong to the same instant as an impact
// of one of their balls.
constexpr double kTouchingGap = 1e-14;
constexpr double kMostOverlap = 1e-9;  // of the radius

/// Overlap beyond rounding has no instant at which it began, and is for the solver that pushes it
/// out. In a heap some pair always overlaps, so this also spares it the search for impacts.
bool anyOverlaps(const Arena& arena, std::span<const BallPair> pairs, const Balls& balls) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const BallPair& pair) {
    Contact c{.a = pair.a, .b = pair.b};
    touch(arena, balls, c);
    const double smaller =
        isBall(c.b) ? std::min(balls.radius[c.a], balls.radius[c.b]) : balls.radius[c.a];
    const double size = length(balls.position[c.a]) + length(arena.center) + arena.radius;
    return c.gap < -std::max(kMostOverlap * smaller, kTouchingGap * size);
  });
}

}  // namespace

IslandFate ExactFlight::run(const StepInput& in, std::span<const std::uint32_t> island,
                            std::span<const BallPair> pairs, std::span<double> reach,
                            Balls& balls) {
  const IslandFate fate = tryStep(in, island, pairs, reach, balls);
  const bool isLeft = fate == IslandFate::Sustained || fate == IslandFate::TooMany;
  if (isLeft && island.size() > kMostKept) giveRoomBack();
  return fate;
}

IslandFate ExactFlight::tryStep(const StepInput& in, std::span<const std::uint32_t> island,
                                std::span<const BallPair> pairs, std::span<double> reach,
                                Balls& balls) {
  begin(in, island, balls);
  if (std::ranges::all_of(pairs, [&](const BallPair& pair) { return stayApart(in, pair); }))
    return IslandFate::Alone;
  if (anyOverlaps(*in.model.arena, pairs, balls)) return IslandFate::Sustained;
  takeHold(in, island, pairs, balls);
  IslandFate fate = simulate(in, pairs, reach, balls);
  if (fate == IslandFate::Done) endStep(in, island, reach, balls);
  if (anyTooFar_) fate = IslandFate::TooFar;
  for (const std::uint32_t i : island) {
    if (fate == IslandFate::Done)
      book(in, i, dt_, balls);
    else
      balls.setState(i, of(i).start);
  }
  return fate;
}

void ExactFlight::giveRoomBack() {
  path_ = std::vector<Path>();  // an empty list in braces would keep the room
  flown_ = std::vector<Flown>();
  pairsOf_ = std::vector<std::uint32_t>();
  events_ = std::vector<Event>();
  inCluster_ = std::vector<std::uint8_t>();
}

void ExactFlight::endStep(const StepInput& in, std::span<const std::uint32_t> island,
                          std::span<double> reach, Balls& balls) {
  flying_.clear();
  for (const std::uint32_t i : island) {
    if (pathOf(i).motion == Motion::Flying && pathOf(i).start < dt_)
      flying_.push_back(i);
    else
      balls.setState(i, stateAt(in.model, pathOf(i), dt_));
  }
  endFlights(in.model, path_, place_, dt_, flying_, balls);
  for (const std::uint32_t i : island) checkReach(in, i, dt_, balls, reach);
}

void ExactFlight::set(const StepInput& in, std::uint32_t i, const Path& path) {
  pathOf(i) = path;
  if (path.motion == Motion::Flying)
    of(i).pull = accelerationBound(in.model, path, path.state, path.start, dt_ - path.start);
}

bool ExactFlight::stayApart(const StepInput& in, const BallPair& pair) const {
  const Path& a = pathOf(pair.a);
  if (a.motion != Motion::Flying) return false;
  if (!isBall(pair.b)) return staysOff(in.model, flyer(pair.a), pair.b, dt_);
  const Path& b = pathOf(pair.b);
  return b.motion == Motion::Flying &&
         wells::stayApart(in.model, flyer(pair.a), flyer(pair.b), std::max(a.start, b.start), dt_);
}

void ExactFlight::begin(const StepInput& in, std::span<const std::uint32_t> island,
                        const Balls& balls) {
  dt_ = in.settings.dt;
  counts_ = {};
  books_ = {};
  ledger_ = {keepsBooks_ ? &books_ : nullptr, in.model.arena->center};
  motionsEnded_ = 0;
  anyTooFar_ = false;
  mostInelastic_ = std::max(kMostInelasticImpacts,
                            kMostInelasticOfBall * static_cast<std::int64_t>(island.size()));
  place_.resize(balls.size());
  makeRoomFor(path_, island.size());
  makeRoomFor(flown_, island.size());
  for (std::size_t k = 0; k < island.size(); ++k) place_[island[k]] = static_cast<std::uint32_t>(k);
  for (const std::uint32_t i : island) set(in, i, {balls.state(i), 0, balls.radius[i]});
}

void ExactFlight::takeHold(const StepInput& in, std::span<const std::uint32_t> island,
                           std::span<const BallPair> pairs, const Balls& balls) {
  events_.clear();
  for (const std::uint32_t i : island) {
    of(i).start = balls.state(i);
    of(i).version = of(i).pairCount = 0;
  }
  // The pairs of ball i are pairsOf_[of(i).firstPair] and the of(i).pairCount - 1 after it.
  for (const BallPair& pair : pairs) {
    ++of(pair.a).pairCount;
    if (isBall(pair.b)) ++of(pair.b).pairCount;
  }
  std::uint32_t next = 0;
  for (const std::uint32_t i : island) {
    of(i).firstPair = next;
    next += std::exchange(of(i).pairCount, 0);
  }
  pairsOf_.resize(next);
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
    for (const std::uint32_t i : {pairs[p].a, pairs[p].b})
      if (isBall(i)) pairsOf_[of(i).firstPair + of(i).pairCount++] = p;
  inCluster_.assign(pairs.size(), 0);
  for (const std::uint32_t i : island) {
    const Path path = pathFrom(in.model, of(i).start, balls.radius[i], 0);
    if (path.motion != Motion::Flying) set(in, i, path);
    bookHold(i, of(i).start, balls);
    foreseeEndOfMotion(in, i);
  }
}

IslandFate ExactFlight::simulate(const StepInput& in, std::span<const BallPair> pairs,
                                 std::span<double> reach, Balls& balls) {
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
    if (!foresee(in, pairs, p)) return IslandFate::Sustained;

  while (!events_.empty()) {
    std::pop_heap(events_.begin(), events_.end(), later);
    const Event event = events_.back();
    events_.pop_back();
    if (isOutdated(pairs, event)) continue;

    if (event.pair == kEndOfMotion) {
      if (++motionsEnded_ > mostInelastic_) return IslandFate::Sustained;
      cluster_.clear();
      clusterBalls_.assign(1, event.ball);
      book(in, event.ball, event.time, balls);
      const BallState before = stateAt(in.model, pathOf(event.ball), event.time);
      set(in, event.ball, pathAfter(in.model, pathOf(event.ball), event.time));
      bookHold(event.ball, before, balls);
      ++of(event.ball).version;
    } else {
      gatherCluster(in, pairs, event, balls);
      const std::int64_t before = counts_.impacts;
      const IslandFate fate = resolve(in, event.time, balls);
      if (fate != IslandFate::Done) return fate;
      // It closes by rounding alone, and nothing will press it: it need not be foreseen again.
      if (counts_.impacts == before) continue;
      for (const std::uint32_t i : clusterBalls_) {
        checkReach(in, i, event.time, balls, reach);
        book(in, i, event.time, balls);
        set(in, i, pathFrom(in.model, balls.state(i), pathOf(i).radius, event.time));
        bookHold(i, balls.state(i), balls);
        ++of(i).version;
      }
    }
    if (!foreseeCluster(in, pairs)) return IslandFate::Sustained;
  }
  return IslandFate::Done;
}

IslandFate ExactFlight::resolve(const StepInput& in, double time, Balls& balls) {
  const bool isElastic = in.settings.elasticity == 1;
  const Bounce bounce = bounceOfLoneBall(in, time, balls);
  if (bounce == Bounce::OfMany && !isElastic && isTooSlow(in, time, balls))
    return IslandFate::Sustained;
  const double elasticity = bounce == Bounce::Last ? 0 : in.settings.elasticity;
  const std::int64_t impulses =
      resolveImpacts(elasticity, in.settings.friction, cluster_, balls, ledger_);
  // It touches and closes no faster than rounding: where a force may press it together, it lasts.
  if (impulses == 0 && mayBePressed(in, time, balls)) return IslandFate::Sustained;
  counts_.impacts += impulses;
  if (bounce == Bounce::Last) endHops(in, time, balls);
  if (cluster_.size() > 1) ++counts_.clusters;
  if (isElastic)
    return counts_.impacts > in.settings.mostImpacts ? IslandFate::TooMany : IslandFate::Done;
  return counts_.impacts > mostInelastic_ ? IslandFate::Sustained : IslandFate::Done;
}

void ExactFlight::book(const StepInput& in, std::uint32_t i, double t, const Balls& balls) {
  if (ledger_) bookPath(ledger_, in.model, pathOf(i), balls.mass[i], t);
}

void ExactFlight::bookHold(std::uint32_t i, const BallState& before, const Balls& balls) {
  if (ledger_ && pathOf(i).motion != Motion::Flying)
    wells::bookHold(ledger_, before, pathOf(i), balls.mass[i]);
}

void ExactFlight::foreseeEndOfMotion(const StepInput& in, std::uint32_t ball) {
  of(ball).end = dt_;
  if (pathOf(ball).motion == Motion::Flying) return;
  const double end = endOfMotion(in.model, pathOf(ball), dt_);
  if (end >= dt_) return;
  of(ball).end = end;
  add({end, kEndOfMotion, ball, of(ball).version, 0});
}

void ExactFlight::add(const Event& event) {
  events_.push_back(event);
  std::push_heap(events_.begin(), events_.end(), later);
}

bool ExactFlight::foresee(const StepInput& in, std::span<const BallPair> pairs, std::uint32_t p) {
  const BallPair& pair = pairs[p];
  if (stayApart(in, pair)) return true;
  const Path& a = pathOf(pair.a);
  // Where a motion ends, its pairs are looked at again.
  double until = of(pair.a).end;
  Encounter next;
  std::uint32_t versionB = 0;
  if (isBall(pair.b)) {
    const Path& b = pathOf(pair.b);
    versionB = of(pair.b).version;
    until = std::min(until, of(pair.b).end);
    next = encounterOfBalls(in.model, a, b, std::max(a.start, b.start), until);
  } else {
    next = encounterWithArena(in.model, a, pair.b, a.start, until);
  }
  if (next.meeting == Meeting::Sustained) return false;
  if (next.meeting == Meeting::Impact) add({next.time, p, pair.a, of(pair.a).version, versionB});
  return true;
}

bool ExactFlight::foreseeCluster(const StepInput& in, std::span<const BallPair> pairs) {
  for (const std::uint32_t i : clusterBalls_) foreseeEndOfMotion(in, i);
  for (const std::uint32_t i : clusterBalls_) {
    for (std::uint32_t k = 0; k < of(i).pairCount; ++k) {
      const std::uint32_t p = pairsOf_[of(i).firstPair + k];
      if (inCluster_[p]) continue;  // foreseen from its other ball
      inCluster_[p] = 1;
      if (!foresee(in, pairs, p)) return false;
    }
  }
  for (const std::uint32_t i : clusterBalls_)
    for (std::uint32_t k = 0; k < of(i).pairCount; ++k)
      inCluster_[pairsOf_[of(i).firstPair + k]] = 0;
  return true;
}

bool ExactFlight::later(const Event& x, const Event& y) {
  return x.time != y.time ? x.time > y.time : x.pair > y.pair;
}

bool ExactFlight::isOutdated(std::span<const BallPair> pairs, const Event& event) const {
  if (event.versionA != of(event.ball).version) return true;
  if (event.pair == kEndOfMotion) return false;
  const std::uint32_t b = pairs[event.pair].b;
  return isBall(b) && event.versionB != of(b).version;
}

// The event's pair, and whatever touches one of its balls at that time, and so on.
void ExactFlight::gatherCluster(const StepInput& in, std::span<const BallPair> pairs,
                                const Event& event, Balls& balls) {
  const Arena& arena = *in.model.arena;
  cluster_.clear();
  clusterBalls_.clear();
  const auto isHere = [&](std::uint32_t i) { return of(i).isInCluster; };
  const auto bring = [&](std::uint32_t i, const BallState& state) {
    balls.setState(i, state);
    clusterBalls_.push_back(i);
    of(i).isInCluster = true;
  };
  const auto include = [&](std::uint32_t p) {
    const auto [a, b] = pairs[p];
    inCluster_[p] = 1;
    cluster_.push_back({.a = a, .b = b});
    if (isBall(b) && !isHere(a) && !isHere(b)) {
      const auto [stateA, stateB] = statesAt(in.model, pathOf(a), pathOf(b), event.time);
      bring(a, stateA);
      bring(b, stateB);
    }
    for (const std::uint32_t i : {a, b})
      if (isBall(i) && !isHere(i)) bring(i, stateAt(in.model, pathOf(i), event.time));
    touch(arena, balls, cluster_.back());
  };
  include(event.pair);
  for (std::size_t n = 0; n < clusterBalls_.size(); ++n) {
    const std::uint32_t i = clusterBalls_[n];
    const Vec3 at = balls.position[i];
    const double touching = kTouchingGap * (length(at) + length(arena.center) + arena.radius);
    for (std::uint32_t k = 0; k < of(i).pairCount; ++k) {
      const std::uint32_t p = pairsOf_[of(i).firstPair + k];
      if (inCluster_[p]) continue;
      const std::uint32_t other = pairs[p].a == i ? pairs[p].b : pairs[p].a;
      if (isBall(other) && !isHere(other)) {
        if (pathOf(other).motion == Motion::Flying &&
            leastGap(in.model, flyer(other), event.time, at, balls.radius[i]) > 2 * touching)
          continue;
        balls.setState(other, stateAt(in.model, pathOf(other), event.time));
      }
      Contact now{.a = pairs[p].a, .b = pairs[p].b};
      touch(arena, balls, now);
      if (now.gap <= touching) include(p);
    }
  }
  for (const std::uint32_t i : clusterBalls_) {
    for (std::uint32_t k = 0; k < of(i).pairCount; ++k)
      inCluster_[pairsOf_[of(i).firstPair + k]] = 0;
    of(i).isInCluster = false;
  }
}

double ExactFlight::pressingBound(const StepInput& in, double time, const Contact& c,
                                  const Balls& balls) const {
  const double substep = dt_ / in.settings.substeps;
  if (isBall(c.b))
    return approachBound(in.model, pathOf(c.a), balls.state(c.a), pathOf(c.b), balls.state(c.b),
                         time, substep);
  return length(in.settings.gravity) +
         accelerationBound(in.model, pathOf(c.a), balls.state(c.a), time, substep);
}

bool ExactFlight::mayBePressed(const StepInput& in, double time, const Balls& balls) const {
  // A ball that runs along the wall is pressed to it by its own inertia.
  return std::any_of(cluster_.begin(), cluster_.end(), [&](const Contact& c) {
    return c.b == kWall || pressingBound(in, time, c, balls) > 0;
  });
}

bool ExactFlight::isTooSlow(const StepInput& in, double time, const Balls& balls) const {
  const double substep = dt_ / in.settings.substeps;
  return std::any_of(cluster_.begin(), cluster_.end(), [&](const Contact& c) {
    const double closing = closingSpeed(balls, c);
    return closing > 0 && closing < pressingBound(in, time, c, balls) * substep / 2;
  });
}

void ExactFlight::checkReach(const StepInput& in, std::uint32_t ball, double t, const Balls& balls,
                             std::span<double> reach) {
  const double left = dt_ - t;
  const BallState now = balls.state(ball);
  const double ahead =
      left > 0
          ? (length(now.velocity) + length(acceleration(*in.model.field, now.position, t)) * left) *
                left
          : 0;
  const double moved = length(now.position - of(ball).start.position) + ahead;
  if (!(moved > reach[ball])) return;  // what is not finite has no reach
  reach[ball] = 2 * moved;
  anyTooFar_ = true;
}

}  // namespace wells
