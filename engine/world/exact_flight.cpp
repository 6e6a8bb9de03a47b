#include "world/exact_flight.h"

#include <algorithm>

#include "contacts/impact_time.h"
#include "contacts/impacts.h"
#include "world/advance.h"

namespace wells {
namespace {

// Gaps up to this (m), times the size of the coordinates, belong to the same instant as an impact
// of one of their balls.
constexpr double kTouchingGap = 1e-14;
constexpr double kMostOverlap = 1e-9;  // of the radius

bool isBall(std::uint32_t partner) {
  return partner < kWall;
}

void touch(const Arena& arena, const Balls& balls, Contact& c) {
  if (isBall(c.b))
    touchBalls(balls, c);
  else
    touchArena(arena, balls, c);
}

double closingSpeed(const Balls& balls, const Contact& c) {
  const double a = dot(balls.velocity[c.a], c.normal);
  return isBall(c.b) ? a - dot(balls.velocity[c.b], c.normal) : a;
}

/// Overlap beyond rounding has no instant at which it began, and is for the solver that pushes it
/// out. In a heap some pair always overlaps, so this also spares it the search for impacts.
bool anyOverlaps(const Arena& arena, std::span<const Contact> pairs, const Balls& balls) {
  return std::any_of(pairs.begin(), pairs.end(), [&](Contact c) {
    touch(arena, balls, c);
    return c.gap < -kMostOverlap * balls.radius[c.a];
  });
}

std::int64_t mostImpacts(double elasticity) {
  return elasticity < 1 ? kMostInelasticImpacts : kMostElasticImpacts;
}

}  // namespace

IslandFate ExactFlight::run(const StepInput& in, std::span<const std::uint32_t> island,
                            std::span<const Contact> pairs, std::span<double> reach, Balls& balls) {
  if (anyOverlaps(in.arena, pairs, balls)) return IslandFate::Sustained;
  begin(in.settings.dt, island, pairs, balls);
  const IslandFate fate = simulate(in, pairs, reach, balls);
  for (const std::uint32_t i : island)
    balls.setState(i, fate == IslandFate::Done ? stateAt(in.model, path_[i], dt_) : start_[i]);
  if (fate != IslandFate::Done) return fate;
  for (const std::uint32_t i : island) {
    if (!isTooFar(i, balls, reach)) continue;
    for (const std::uint32_t j : island) balls.setState(j, start_[j]);
    return IslandFate::TooFar;
  }
  return fate;
}

void ExactFlight::begin(double dt, std::span<const std::uint32_t> island,
                        std::span<const Contact> pairs, const Balls& balls) {
  dt_ = dt;
  radius_ = balls.radius.data();
  counts_ = {};
  events_.clear();
  path_.resize(balls.size());
  start_.resize(balls.size());
  version_.resize(balls.size());
  firstPair_.resize(balls.size());
  pairCount_.resize(balls.size());
  for (const std::uint32_t i : island) {
    start_[i] = balls.state(i);
    path_[i] = {start_[i], 0};
    version_[i] = 0;
    pairCount_[i] = 0;
  }
  // The pairs of ball i are pairsOf_[firstPair_[i]] and the pairCount_[i] - 1 after it.
  for (const Contact& pair : pairs) {
    ++pairCount_[pair.a];
    if (isBall(pair.b)) ++pairCount_[pair.b];
  }
  std::uint32_t next = 0;
  for (const std::uint32_t i : island) {
    firstPair_[i] = next;
    next += pairCount_[i];
    pairCount_[i] = 0;
  }
  pairsOf_.resize(next);
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
    for (const std::uint32_t i : {pairs[p].a, pairs[p].b})
      if (isBall(i)) pairsOf_[firstPair_[i] + pairCount_[i]++] = p;
  inCluster_.assign(pairs.size(), 0);
}

IslandFate ExactFlight::simulate(const StepInput& in, std::span<const Contact> pairs,
                                 std::span<double> reach, Balls& balls) {
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
    if (!foresee(in, pairs, p)) return IslandFate::Sustained;

  while (!events_.empty()) {
    std::pop_heap(events_.begin(), events_.end(), later);
    const Event event = events_.back();
    events_.pop_back();
    if (isOutdated(event, pairs[event.pair])) continue;

    gatherCluster(in, pairs, event, balls);
    if (in.settings.elasticity < 1 && isTooSlow(in, event.time, balls))
      return IslandFate::Sustained;
    const std::int64_t impulses = resolveImpacts(in.settings, cluster_, balls);
    if (impulses == 0) return IslandFate::Sustained;  // it touches and does not close: it lasts
    counts_.impacts += impulses;
    if (cluster_.size() > 1) ++counts_.clusters;
    if (counts_.impacts > mostImpacts(in.settings.elasticity)) return IslandFate::Sustained;

    for (const std::uint32_t i : clusterBalls_) {
      if (isTooFar(i, balls, reach)) return IslandFate::TooFar;
      path_[i] = {balls.state(i), event.time};
      ++version_[i];
    }
    if (!foreseeCluster(in, pairs)) return IslandFate::Sustained;
  }
  return IslandFate::Done;
}

bool ExactFlight::foresee(const StepInput& in, std::span<const Contact> pairs, std::uint32_t p) {
  const Contact& pair = pairs[p];
  const Trajectory& a = path_[pair.a];
  Encounter next;
  std::uint32_t versionB = 0;
  if (isBall(pair.b)) {
    const Trajectory& b = path_[pair.b];
    versionB = version_[pair.b];
    next = encounterOfBalls(in.model, a, radius_[pair.a], b, radius_[pair.b],
                            std::max(a.start, b.start), dt_);
  } else {
    next = encounterWithArena(in.model, in.arena, a, radius_[pair.a], pair.b, a.start, dt_);
  }
  if (next.meeting == Meeting::Sustained) return false;
  if (next.meeting == Meeting::Impact) {
    events_.push_back({next.time, p, version_[pair.a], versionB});
    std::push_heap(events_.begin(), events_.end(), later);
  }
  return true;
}

bool ExactFlight::foreseeCluster(const StepInput& in, std::span<const Contact> pairs) {
  for (const std::uint32_t i : clusterBalls_)
    for (std::uint32_t k = 0; k < pairCount_[i]; ++k) {
      const std::uint32_t p = pairsOf_[firstPair_[i] + k];
      if (inCluster_[p]) continue;  // foreseen from its other ball
      inCluster_[p] = 1;
      if (!foresee(in, pairs, p)) return false;
    }
  for (const std::uint32_t i : clusterBalls_)
    for (std::uint32_t k = 0; k < pairCount_[i]; ++k) inCluster_[pairsOf_[firstPair_[i] + k]] = 0;
  return true;
}

bool ExactFlight::later(const Event& x, const Event& y) {
  return x.time != y.time ? x.time > y.time : x.pair > y.pair;
}

bool ExactFlight::isOutdated(const Event& event, const Contact& pair) const {
  return event.versionA != version_[pair.a] ||
         (isBall(pair.b) && event.versionB != version_[pair.b]);
}

// The event's pair, and whatever touches one of its balls at that time, and so on.
void ExactFlight::gatherCluster(const StepInput& in, std::span<const Contact> pairs,
                                const Event& event, Balls& balls) {
  cluster_.clear();
  clusterBalls_.clear();
  const auto isHere = [&](std::uint32_t i) {
    return std::find(clusterBalls_.begin(), clusterBalls_.end(), i) != clusterBalls_.end();
  };
  const auto bring = [&](std::uint32_t i) {
    if (!isBall(i) || isHere(i)) return;
    balls.setState(i, stateAt(in.model, path_[i], event.time));
    clusterBalls_.push_back(i);
  };
  const auto include = [&](std::uint32_t p) {
    inCluster_[p] = 1;
    cluster_.push_back({.a = pairs[p].a, .b = pairs[p].b});
    bring(pairs[p].a);
    bring(pairs[p].b);
    touch(in.arena, balls, cluster_.back());
  };
  include(event.pair);
  for (std::size_t n = 0; n < clusterBalls_.size(); ++n) {
    const std::uint32_t i = clusterBalls_[n];
    for (std::uint32_t k = 0; k < pairCount_[i]; ++k) {
      const std::uint32_t p = pairsOf_[firstPair_[i] + k];
      if (inCluster_[p]) continue;
      const std::uint32_t other = pairs[p].a == i ? pairs[p].b : pairs[p].a;
      if (isBall(other) && !isHere(other))
        balls.setState(other, stateAt(in.model, path_[other], event.time));
      Contact now{.a = pairs[p].a, .b = pairs[p].b};
      touch(in.arena, balls, now);
      const double size = length(balls.position[i]) + length(in.arena.center) + in.arena.radius;
      if (now.gap <= kTouchingGap * size) include(p);
    }
  }
  for (const std::uint32_t i : clusterBalls_)
    for (std::uint32_t k = 0; k < pairCount_[i]; ++k) inCluster_[pairsOf_[firstPair_[i] + k]] = 0;
}

bool ExactFlight::isTooSlow(const StepInput& in, double time, const Balls& balls) const {
  const double substep = dt_ / in.settings.substeps;
  const double gravity = length(in.settings.gravity);
  for (const Contact& c : cluster_) {
    double pressing = accelerationBound(in.model, balls.state(c.a), time, substep);
    pressing +=
        isBall(c.b) ? accelerationBound(in.model, balls.state(c.b), time, substep) : gravity;
    const double closing = closingSpeed(balls, c);
    if (closing > 0 && closing < pressing * substep / 2) return true;
  }
  return false;
}

bool ExactFlight::isTooFar(std::uint32_t ball, const Balls& balls, std::span<double> reach) const {
  return isBeyondReach(start_[ball].position, balls.state(ball), dt_, reach[ball]);
}

}  // namespace wells
