// What a crowd takes from the world and from the step before, and what it gives back.
#include <algorithm>
#include <array>

#include "math/room.h"
#include "world/crowd.h"

namespace wells {
namespace {

constexpr double kFarApart = 1e6;             // m, of the two balls that idle lanes have
constexpr std::uint32_t kNever = 0xfffffff0;  // no substep, nor the one before the first
constexpr std::size_t kLeastBalls = 256;      // that a thread copies
constexpr std::size_t kLeastContacts = 256;   // that a thread looks up
// Times as many contacts as balls, which it takes longer to go through one after the other than to
// look up those of each ball.
constexpr std::size_t kFarMore = 8;

}  // namespace

void Crowd::gather(std::span<const std::uint32_t> ids, const Balls& balls, ThreadPool& pool) {
  const std::size_t count = island_.size();
  const std::size_t idle = 2 * threads_;
  if (workers_.size() < threads_) workers_.resize(threads_);
  makeRoomFor(placeOf_, balls.size());
  makeRoomFor(place_, count + idle);
  makeRoomFor(momentum_, count + idle);
  makeRoomFor(gained_, count + idle);
  pool.forRanges(count, kLeastBalls, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) placeOf_[island_[k]] = static_cast<std::uint32_t>(k);
  });
  // In the order of the world, of which more arrays are read than of the crowd written.
  pool.forRanges(count, kLeastBalls, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const std::uint32_t i : ids.subspan(begin, end - begin)) {
      const std::uint32_t k = placeOf_[i];
      const Vec3& x = balls.position[i];
      const Vec3& v = balls.velocity[i];
      const Vec3 s = balls.radius[i] * balls.spin[i];
      place_[k] = {x.x(), x.y(), x.z(), balls.radius[i]};
      momentum_[k] = {v.x(), v.y(), v.z(), 1 / balls.mass[i], s.x(), s.y(), s.z(), 0};
    }
  });
  for (std::size_t k = 0; k < idle; ++k) {
    place_[count + k] = {static_cast<double>(k) * kFarApart, 0, 0, 1};
    momentum_[count + k] = {.inverseMass = 1};
    gained_[count + k] = {};
  }
}

void Crowd::findContacts(const CrowdInput& in, ThreadPool& pool) {
  const auto arena =
      std::ranges::partition_point(in.pairs, isBall, [](const BallPair& p) { return p.b; });
  pairs_.find({in.pairs.begin(), arena}, island_, placeOf_, in.settings.dt, place_.data(),
              momentum_.data(), pool);
  batches_.split(pairs_.near(), {arena, in.pairs.end()}, placeOf_, threads_, pool);
  makeRoomForLasting();
  std::ranges::fill(touchedIn_, kNever);
  startFrom(in.memory, pool);
}

// What has not touched yet lasts from nowhere, whatever stands there.
void Crowd::makeRoomForLasting() {
  lasting_.resize(batches_.pairs().size());
  touchedIn_.resize(batches_.pairs().size(), kNever);
}

/// From what the contacts ended the last step with.
void Crowd::startFrom(const ContactMemory& memory, ThreadPool& pool) {
  const double scale = memory.scaleTo(rules_.h);
  // A ball that is not of the island has no place in it, or another's.
  const auto isMine = [&](std::uint32_t i) {
    return placeOf_[i] < island_.size() && island_[placeOf_[i]] == i;
  };
  const auto start = [&](const ContactMemory::Kept& kept) {
    if (!isMine(kept.a) || (isBall(kept.b) && !isMine(kept.b))) return;
    const std::uint32_t partner = isBall(kept.b) ? placeOf_[kept.b] : kept.b;
    const std::uint32_t slot = batches_.find(placeOf_[kept.a], partner);
    if (slot == ContactBatches::kNoPair) return;
    const Vec3 tangent = scale * kept.tangentImpulse;
    touchedIn_[slot] = 0;
    lasting_[slot] = {scale * kept.normalImpulse, tangent.x(), tangent.y(), tangent.z()};
  };
  const auto all = memory.contacts();
  if (all.size() > kFarMore * island_.size()) {
    for (const std::uint32_t i : island_) memory.forEachOf(i, start);
    return;
  }
  pool.forRanges(all.size(), kLeastContacts, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const ContactMemory::Kept& kept : all.subspan(begin, end - begin)) start(kept);
  });
}

void Crowd::scatter(std::span<const std::uint32_t> ids, Balls& balls) const {
  for (const std::uint32_t i : ids) {
    const Place& x = place_[placeOf_[i]];
    const Momentum& m = momentum_[placeOf_[i]];
    balls.position[i] = {x.x, x.y, x.z};
    balls.velocity[i] = {m.vx, m.vy, m.vz};
    balls.spin[i] = Vec3(m.sx, m.sy, m.sz) / x.radius;
  }
}

void Crowd::keep(ContactMemory& memory) const {
  forEachBlock([&](PartnerKind kind, const ContactBlock& block, const ContactFlight& flight) {
    std::array<ContactMemory::Kept, kContactLanes> some;
    std::size_t count = 0;
    // Without a branch for each: whether a contact lasts cannot be foretold.
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      some[count] = {island_[block.a[lane]],
                     kind == PartnerKind::Ball ? island_[block.b[lane]] : partnerOf(kind),
                     block.normal[lane],
                     {block.tx[lane], block.ty[lane], block.tz[lane]},
                     Vec3::Zero()};
      count += flight.lasts[lane] * block.normal[lane] > 0 ? 1 : 0;
    }
    memory.add(std::span(some).first(count));
  });
}

}  // namespace wells
