#include "world/crowd.h"

#include <algorithm>
#include <numeric>

#include "contacts/lasting_force.h"
#include "contacts/ledger.h"
#include "contacts/substep_rules.h"

namespace wells {
namespace {

constexpr double kFarApart = 1e6;  // m, of the two balls that idle lanes have

template <class Record>
void resizeFor(std::vector<Record>& records, std::size_t balls) {
  if (records.size() < balls + 2) records.resize(balls + 2);
}

}  // namespace

void Crowd::step(const Settings& settings, const PathModel& model,
                 std::span<const std::uint32_t> island, std::span<const BallPair> pairs,
                 std::span<const std::uint8_t> isLeaning, const ContactMemory& memory, Balls& balls,
                 Books* books) {
  StageScope stage(clock_, Stage::Batches);
  const double h = settings.dt / settings.substeps;
  island_ = island;
  rules_ = {h, settings.elasticity, settings.friction, *model.arena, 0};
  gather(settings, pairs, memory, balls);
  for (int n = 0; n < settings.substeps; ++n) {
    rules_.substep = static_cast<std::uint32_t>(n + 1);
    const double start = n * h;
    stage.next(Stage::Flight);
    if (books) bookFlights(model, start, isLeaning, balls, *books);
    fly(model, start, isLeaning);
    const Booking flown = books ? bookingOf(model, start + h, balls) : Booking{};
    stage.next(Stage::Prepare);
    const CrowdSubstep substep = prepare();
    stage.next(Stage::Solve);
    solve(settings, substep);
    const Booking solved = books ? bookingOf(model, start + h, balls) : Booking{};
    const Books impulses = books ? booksOfImpulses(model, balls) : Books{};
    stage.next(Stage::Push);
    shift();
    const Booking shifted = books ? bookingOf(model, start + h, balls) : Booking{};
    pushOut();
    if (books)
      bookSubstep(flown, solved, shifted, bookingOf(model, start + h, balls), impulses, *books);
  }
  stage.next(Stage::Batches);
  scatter(balls);
}

void Crowd::gather(const Settings& settings, std::span<const BallPair> pairs,
                   const ContactMemory& memory, const Balls& balls) {
  const std::size_t count = island_.size();
  if (placeOf_.size() < balls.size()) placeOf_.resize(balls.size());
  resizeFor(place_, count);
  resizeFor(momentum_, count);
  resizeFor(flown_, count);
  position_.resize(count);
  velocity_.resize(count);
  all_.resize(count);
  std::iota(all_.begin(), all_.end(), 0u);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t i = island_[k];
    const Vec3& x = balls.position[i];
    const Vec3& v = balls.velocity[i];
    const Vec3 s = balls.radius[i] * balls.spin[i];
    placeOf_[i] = k;
    place_[k] = {x.x(), x.y(), x.z(), balls.radius[i]};
    momentum_[k] = {v.x(), v.y(), v.z(), 1 / balls.mass[i], s.x(), s.y(), s.z(), 0};
  }
  for (std::size_t idle = 0; idle < 2; ++idle) {
    place_[count + idle] = {static_cast<double>(idle) * kFarApart, 0, 0, 1};
    momentum_[count + idle] = {.inverseMass = 1};
    flown_[count + idle] = {};
  }

  batches_.split(pairs, placeOf_, count);
  const std::size_t pairCount = pairs.size();
  lasting_.resize(pairCount + 1);
  touchedIn_.resize(pairCount + 1);
  touching_.resize(pairCount + 1);
  const double substep = settings.dt / settings.substeps;
  const double scale = memory.scaleTo(substep);
  const auto source = batches_.source();
  constexpr std::uint32_t kNever = 0xfffffff0;
  for (std::size_t n = 0; n < pairCount; ++n) {
    const auto [a, b] = pairs[source[n]];
    const ContactMemory::Kept* const kept = memory.find(a, b);
    touchedIn_[n] = kept ? 0 : kNever;
    lasting_[n] = {};
    if (!kept) continue;
    const Vec3 tangent = scale * kept->tangentImpulse;
    lasting_[n] = {scale * kept->normalImpulse, tangent.x(), tangent.y(), tangent.z()};
  }
  lasting_[pairCount] = {};
  touchedIn_[pairCount] = kNever;

  blocksOf_.clear();
  std::size_t blocks = 0;
  for (const ContactBatch& batch : batches_.batches()) {
    blocksOf_.push_back({blocks, 0});
    blocks += (batch.last - batch.first + kContactLanes - 1) / kContactLanes;
  }
  if (blocks_.size() < blocks) blocks_.resize(blocks);
  if (flights_.size() < blocks) flights_.resize(blocks);
  arrays_ = {place_.data(),
             momentum_.data(),
             flown_.data(),
             island_.data(),
             static_cast<std::uint32_t>(count),
             batches_.pairs().data(),
             lasting_.data(),
             touchedIn_.data(),
             static_cast<std::uint32_t>(pairCount)};
}

void Crowd::fly(const PathModel& model, double start, std::span<const std::uint8_t> isLeaning) {
  const std::size_t count = island_.size();
  for (std::size_t k = 0; k < count; ++k) {
    position_[k] = {place_[k].x, place_[k].y, place_[k].z};
    velocity_[k] = {momentum_[k].vx, momentum_[k].vy, momentum_[k].vz};
  }
  flyThrough(*model.integrator, {model.field, start, rules_.h, model.drag}, all_, position_.data(),
             velocity_.data());
  for (std::size_t k = 0; k < count; ++k) {
    Momentum& momentum = momentum_[k];
    const Vec3 before(momentum.vx, momentum.vy, momentum.vz);
    if (isLeaning[island_[k]]) {
      position_[k] = Vec3(place_[k].x, place_[k].y, place_[k].z) + before * rules_.h;
      velocity_[k] = before;
    }
    const Vec3& x = position_[k];
    const Vec3& v = velocity_[k];
    const Vec3 gained = v - before;
    place_[k] = {x.x(), x.y(), x.z(), place_[k].radius};
    momentum.vx = v.x();
    momentum.vy = v.y();
    momentum.vz = v.z();
    flown_[k] = {v.x(), v.y(), v.z(), 0, gained.x(), gained.y(), gained.z(), 0};
  }
}

CrowdSubstep Crowd::prepare() {
  CrowdSubstep substep;
  const auto batches = batches_.batches();
  for (std::size_t n = 0; n < batches.size(); ++n) {
    const auto [partner, first, last] = batches[n];
    const std::size_t count = findTouching(partner, rules_, arrays_, first, last, touching_.data());
    Blocks& blocks = blocksOf_[n];
    blocks.count = (count + kContactLanes - 1) / kContactLanes;
    prepareContacts(partner, rules_, arrays_, std::span(touching_).first(count),
                    blocks_.data() + blocks.first, flights_.data() + blocks.first, substep);
  }
  return substep;
}

void Crowd::solve(const Settings& settings, const CrowdSubstep& substep) {
  const bool rests = !substep.anyImpact;
  const int most = rests ? std::max(settings.iterations, kPassesAtRest) : settings.iterations;
  for (int pass = 0; pass < most; ++pass) {
    double changed = 0;
    forEachBatch([&](PartnerKind partner, std::span<ContactBlock> blocks, const ContactFlight*) {
      const Watch watch = rests ? Watch::Changes : Watch::No;
      changed = std::max(changed, solveContacts(partner, watch, rules_, arrays_, blocks));
    });
    if (rests && !(changed > kSolved * substep.builtUp)) return;
  }
}

void Crowd::shift() {
  forEachBatch([&](PartnerKind partner, std::span<ContactBlock> blocks, const ContactFlight* f) {
    shiftByForces(partner, rules_, arrays_, blocks, f);
  });
}

void Crowd::pushOut() {
  forEachBatch([&](PartnerKind partner, std::span<ContactBlock> blocks, const ContactFlight*) {
    pushOverlapsOut(partner, rules_, arrays_, blocks);
  });
}

void Crowd::scatter(Balls& balls) const {
  for (std::size_t k = 0; k < island_.size(); ++k) {
    const Place& x = place_[k];
    const Momentum& m = momentum_[k];
    const std::uint32_t i = island_[k];
    balls.setState(i,
                   {{x.x, x.y, x.z}, {m.vx, m.vy, m.vz}, Vec3(m.sx, m.sy, m.sz) / balls.radius[i]});
  }
}

void Crowd::keep(std::span<const BallPair> pairs, ContactMemory& memory) const {
  const auto source = batches_.source();
  for (std::size_t n = 0; n < source.size(); ++n) {
    const LastingImpulse& lasting = lasting_[n];
    if (touchedIn_[n] != rules_.substep || !(lasting.normal > 0)) continue;
    const auto [a, b] = pairs[source[n]];
    memory.add({a, b, lasting.normal, {lasting.tx, lasting.ty, lasting.tz}, Vec3::Zero()});
  }
}

}  // namespace wells
