#include "world/crowd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contacts/substep_rules.h"
#include "math/room.h"

namespace wells {
namespace {

constexpr std::size_t kLeastPairs = 256;  // that a shared batch has
constexpr std::size_t kLeastBalls = 256;  // that a thread copies
constexpr std::size_t kFlightBlock = 64;  // balls, that fit the cache as components

/// Balls in a row, an array for each component.
class FlightBlock {
 public:
  FlightArrays arrays(std::size_t count) {
    return {x_.data(), y_.data(), z_.data(), vx_.data(), vy_.data(), vz_.data(), count};
  }

 private:
  using Component = std::array<double, kFlightBlock>;
  Component x_, y_, z_, vx_, vy_, vz_;
};

}  // namespace

void Crowd::step(const CrowdInput& in, Balls& balls, ThreadPool& pool, Books* books) {
  const StageScope stage(clock_, Stage::Batches);
  const int substeps = in.settings.substeps;
  const double h = in.settings.dt / substeps;
  order_.sort(balls, in.island);
  island_ = order_.ids();
  rules_ = {h, in.settings.elasticity, in.settings.friction, *in.model.arena, 0};
  threads_ = static_cast<std::size_t>(pool.threads());
  gather(in.island, balls, pool);
  findContacts(in, pool);
  planGroups();
  for (int n = 0; n < substeps; ++n) {
    rules_.substep = static_cast<std::uint32_t>(n + 1);
    isLastSubstep_ = n + 1 == substeps;
    if (books)
      runBookedSubstep(in, n * h, pool, balls, *books);
    else
      runSubstep(in, n * h, pool);
  }
  pool.forRanges(island_.size(), kLeastBalls, [&](std::size_t begin, std::size_t end, std::size_t) {
    scatter(in.island.subspan(begin, end - begin), balls);
  });
}

void Crowd::runSubstep(const CrowdInput& in, double start, ThreadPool& pool) {
  pool.run([&](int number, Barrier& barrier) {
    const auto thread = static_cast<std::size_t>(number);
    StageScope stage(thread == 0 ? clock_ : nullptr, Stage::Flight);
    fly(in, start, partOf(island_.size(), kFlightBlock, thread, threads_));
    barrier.wait();
    stage.next(Stage::Prepare);
    findLate(thread, barrier);
    prepare(thread, barrier);
    stage.next(Stage::Solve);
    solve(in.settings, thread, barrier);
    stage.next(Stage::Push);
    shift(thread, barrier);
    pushOut(thread, barrier);
  });
}

/// Who goes through which batches.
void Crowd::planGroups() {
  groups_.clear();
  const auto batches = batches_.batches();
  for (std::size_t n = 0; n < batches.size(); ++n) {
    const std::size_t size = batches[n].last - batches[n].first;
    const Sharing sharing = batches[n].tile != kNoTile            ? Sharing::Tiles
                            : threads_ > 1 && size >= kLeastPairs ? Sharing::Batch
                                                                  : Sharing::Nothing;
    if (!groups_.empty() && groups_.back().sharing == sharing && sharing != Sharing::Batch)
      groups_.back().last = n + 1;
    else
      groups_.push_back({n, n + 1, sharing});
  }
  parts_.assign(batches.size() * threads_, {});
}

CrowdArrays Crowd::arraysOf(std::size_t thread) {
  return {place_.data(),
          momentum_.data(),
          gained_.data(),
          island_.data(),
          batches_.pairs().data(),
          lasting_.data(),
          touchedIn_.data(),
          static_cast<std::uint32_t>(island_.size() + 2 * thread),
          static_cast<std::uint32_t>(batches_.firstIdle() + thread)};
}

void Crowd::fly(const CrowdInput& in, double start, IndexRange range) {
  FlightBlock block;
  const Flight flight{in.model.field, start, rules_.h, in.model.drag};
  for (std::size_t first = range.begin; first < range.end; first += kFlightBlock) {
    const FlightArrays arrays = block.arrays(std::min(kFlightBlock, range.end - first));
    for (std::size_t k = 0; k < arrays.count; ++k) {
      const Place& place = place_[first + k];
      const Momentum& momentum = momentum_[first + k];
      arrays.x[k] = place.x;
      arrays.y[k] = place.y;
      arrays.z[k] = place.z;
      arrays.vx[k] = momentum.vx;
      arrays.vy[k] = momentum.vy;
      arrays.vz[k] = momentum.vz;
    }
    flyThrough(*in.model.integrator, flight, arrays);
    for (std::size_t k = 0; k < arrays.count; ++k) {
      Place& place = place_[first + k];
      Momentum& momentum = momentum_[first + k];
      Gained& gained = gained_[first + k];
      if (in.isLeaning[island_[first + k]]) {
        place.x += momentum.vx * rules_.h;
        place.y += momentum.vy * rules_.h;
        place.z += momentum.vz * rules_.h;
        gained = {};
        continue;
      }
      const double vx = arrays.vx[k], vy = arrays.vy[k], vz = arrays.vz[k];
      gained = {vx - momentum.vx, vy - momentum.vy, vz - momentum.vz, 0};
      place = {arrays.x[k], arrays.y[k], arrays.z[k], place.radius};
      momentum.vx = vx;
      momentum.vy = vy;
      momentum.vz = vz;
    }
  }
}

template <class Action>
void Crowd::forEachPart(std::size_t thread, Barrier& barrier, Action action) {
  const auto batches = batches_.batches();
  for (const Group& group : groups_) {
    for (std::size_t n = group.first; n < group.last; ++n)
      if (takesPart(thread, group.sharing, batches[n]))
        action(n, batches[n].partner, parts_[n * threads_ + thread]);
    barrier.wait();
  }
}

bool Crowd::takesPart(std::size_t thread, Sharing sharing, const ContactBatch& batch) const {
  switch (sharing) {
    case Sharing::Tiles:
      return batch.tile * threads_ / batches_.tiles() == thread;
    case Sharing::Batch:
      return true;
    case Sharing::Nothing:
      return thread == 0;
  }
  return false;
}

std::span<const std::uint32_t> Crowd::touching(std::size_t thread, PartnerKind partner,
                                               const IndexPair* pairs, std::size_t first,
                                               std::size_t last) {
  std::vector<std::uint32_t>& list = workers_[thread].touching;
  makeRoomFor(list, last - first);
  CrowdArrays arrays = arraysOf(thread);
  arrays.pairs = pairs;
  return {list.data(), findTouching(partner, rules_, arrays, static_cast<std::uint32_t>(first),
                                    static_cast<std::uint32_t>(last), list.data())};
}

// Where something has been deflected, far pairs touch, which were not kept ready.
void Crowd::findLate(std::size_t thread, Barrier& barrier) {
  const auto far = pairs_.far(thread);
  workers_[thread].late = touching(thread, PartnerKind::Ball, far.data(), 0, far.size());
  barrier.wait();
  if (thread == 0) addLate();
  barrier.wait();
}

void Crowd::addLate() {
  const std::uint32_t idle = arraysOf(0).idleBall;
  for (std::size_t thread = 0; thread < threads_; ++thread) {
    const auto far = pairs_.far(thread);
    for (const std::uint32_t n : workers_[thread].late) {
      batches_.add(far[n]);
      far[n] = {idle, idle + 1};  // which never touch
    }
  }
  const std::size_t first = batches_.firstLate();
  const std::size_t last = batches_.pairs().size();
  if (first == last) return;
  makeRoomForLasting();
  batches_.setLate(touching(0, PartnerKind::Ball, batches_.pairs().data(), first, last));
  planGroups();
}

// Nothing moves yet, so each thread goes through all that is its own.
void Crowd::prepare(std::size_t thread, Barrier& barrier) {
  const CrowdArrays arrays = arraysOf(thread);
  const auto batches = batches_.batches();
  Worker& worker = workers_[thread];
  worker.substep = {};
  worker.used = 0;
  for (const Group& group : groups_) {
    for (std::size_t n = group.first; n < group.last; ++n) {
      if (!takesPart(thread, group.sharing, batches[n])) continue;
      const auto [partner, of, tile, first, last] = batches[n];
      const IndexRange range = group.sharing == Sharing::Batch
                                   ? partOf(last - first, kContactLanes, thread, threads_)
                                   : IndexRange{0, last - first};
      const auto list =
          of == ContactBatch::Of::Late
              ? batches_.late().subspan(first + range.begin, range.end - range.begin)
              : touching(thread, partner, arrays.pairs, first + range.begin, first + range.end);
      Part& part = parts_[n * threads_ + thread];
      part = {worker.used, (list.size() + kContactLanes - 1) / kContactLanes};
      worker.used += part.count;
      makeRoomFor(worker.blocks, worker.used);
      makeRoomFor(worker.flights, worker.used);
      prepareContacts(partner, rules_, arrays, list, worker.blocks.data() + part.first,
                      worker.flights.data() + part.first, worker.substep);
    }
  }
  barrier.wait();
}

CrowdSubstep Crowd::substepOfAll() const {
  CrowdSubstep all;
  for (const Worker& worker : std::span(workers_).first(threads_)) {
    all.anyImpact = all.anyImpact || worker.substep.anyImpact;
    all.closing = std::max(all.closing, worker.substep.closing);
  }
  return all;
}

void Crowd::solve(const Settings& settings, std::size_t thread, Barrier& barrier) {
  const CrowdArrays arrays = arraysOf(thread);
  forEachPart(thread, barrier, [&](std::size_t, PartnerKind partner, const Part& part) {
    startFromLasting(partner, rules_, arrays, blocksOf(thread, part));
  });
  const CrowdSubstep substep = substepOfAll();
  // Impacts that lose nothing gain energy until they are solved.
  const bool isLossless = substep.anyImpact && rules_.elasticity == 1;
  const bool isToBeSolved = !substep.anyImpact || isLossless;
  const Watch watch = isToBeSolved ? Watch::Changes : Watch::No;
  const int wanted = isLossless ? kPassesLossless : isToBeSolved ? kPassesAtRest : 1;
  const int most = std::max(settings.iterations, wanted);
  // Friction waits for the normal impulses that bound it: the last half of the passes has it, and
  // the others cost half as much. Where they go on until all is solved, all have it.
  const int firstThatRubs = isToBeSolved ? 0 : most - std::max(1, most / 2);
  CrowdRules smooth = rules_;
  smooth.friction = 0;
  for (int pass = 0; pass < most; ++pass) {
    // The other parity may still be read by a thread that is late.
    double& changed = workers_[thread].changed[pass % 2];
    changed = 0;
    const CrowdRules& rules = pass < firstThatRubs ? smooth : rules_;
    forEachPart(thread, barrier, [&](std::size_t, PartnerKind partner, const Part& part) {
      changed =
          std::max(changed, solveContacts(partner, watch, rules, arrays, blocksOf(thread, part)));
    });
    if (!isToBeSolved) continue;
    double mostChanged = 0;
    for (const Worker& worker : std::span(workers_).first(threads_))
      mostChanged = std::max(mostChanged, worker.changed[pass % 2]);
    if (!(mostChanged > kSolved * substep.closing)) return;
  }
}

void Crowd::shift(std::size_t thread, Barrier& barrier) {
  const CrowdArrays arrays = arraysOf(thread);
  forEachPart(thread, barrier, [&](std::size_t, PartnerKind partner, const Part& part) {
    shiftByForces(partner, rules_, arrays, blocksOf(thread, part),
                  workers_[thread].flights.data() + part.first);
  });
}

void Crowd::pushOut(std::size_t thread, Barrier& barrier) {
  const CrowdArrays arrays = arraysOf(thread);
  forEachPart(thread, barrier, [&](std::size_t, PartnerKind partner, const Part& part) {
    pushOverlapsOut(partner, rules_, arrays, blocksOf(thread, part));
  });
  if (thread == 0 && isLastSubstep_) keepInArena();
}

// Whoever was pushed into ground or wall by others, or would leave it by itself later: at the end
// of a step the arena is not entered.
void Crowd::keepInArena() {
  for (const ContactBatch& batch : batches_.batches()) {
    if (batch.partner == PartnerKind::Ball) continue;
    for (const IndexPair& pair : batches_.pairs().subspan(batch.first, batch.last - batch.first)) {
      Place& at = place_[pair.a];
      const double left = kLeftOverlap * at.radius;
      if (batch.partner == PartnerKind::Ground) {
        at.y = std::max(at.y, rules_.arena.center.y() + at.radius - left);
        continue;
      }
      const double x = at.x - rules_.arena.center.x();
      const double z = at.z - rules_.arena.center.z();
      const double fromAxis = std::sqrt(x * x + z * z);
      const double most = rules_.arena.radius - at.radius + left;
      if (fromAxis <= most || most < 0) continue;
      at.x = rules_.arena.center.x() + x * (most / fromAxis);
      at.z = rules_.arena.center.z() + z * (most / fromAxis);
    }
  }
}

}  // namespace wells
