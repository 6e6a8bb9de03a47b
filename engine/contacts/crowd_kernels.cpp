#include "contacts/crowd_kernels.h"

#include <algorithm>

#include "contacts/contact.h"
#include "contacts/partners.h"
#include "contacts/substep_rules.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contacts/crowd_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

// Where registers hold kContactLanes doubles, records are transposed in them.
#undef WELLS_FOUR_LANES
#define WELLS_FOUR_LANES (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kContactLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D kTag;
constexpr std::size_t kLanes = hn::MaxLanes(kTag);

struct V3 {
  V x, y, z;
};

struct V4 {
  V x, y, z, w;
};

HWY_INLINE V set(double value) {
  return hn::Set(kTag, value);
}
HWY_INLINE V load(const double* at) {
  return hn::Load(kTag, at);
}
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V3 operator+(const V3& a, const V3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE V3 operator-(const V3& a, const V3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V3 scaled(V by, const V3& a) {
  return {hn::Mul(by, a.x), hn::Mul(by, a.y), hn::Mul(by, a.z)};
}
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE V3 choose(M which, const V3& a, const V3& b) {
  return {hn::IfThenElse(which, a.x, b.x), hn::IfThenElse(which, a.y, b.y),
          hn::IfThenElse(which, a.z, b.z)};
}
HWY_INLINE V3 xyz(const V4& a) {
  return {a.x, a.y, a.z};
}

/// Four doubles from each of the records that `index` names, a lane each.
template <class At>
HWY_INLINE V4 loadQuads(At at) {
#if WELLS_FOUR_LANES
  const V a = load(at(0)), b = load(at(1)), c = load(at(2)), d = load(at(3));
  const V ab02 = hn::InterleaveLower(kTag, a, b), ab13 = hn::InterleaveUpper(kTag, a, b);
  const V cd02 = hn::InterleaveLower(kTag, c, d), cd13 = hn::InterleaveUpper(kTag, c, d);
  return {hn::ConcatLowerLower(kTag, cd02, ab02), hn::ConcatLowerLower(kTag, cd13, ab13),
          hn::ConcatUpperUpper(kTag, cd02, ab02), hn::ConcatUpperUpper(kTag, cd13, ab13)};
#else
  HWY_ALIGN double part[4][kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t k = 0; k < 4; ++k) part[k][lane] = at(lane)[k];
  return {load(part[0]), load(part[1]), load(part[2]), load(part[3])};
#endif
}

template <class At>
HWY_INLINE void storeQuads(const V4& v, At at) {
#if WELLS_FOUR_LANES
  const V ab01 = hn::InterleaveLower(kTag, v.x, v.y), cd01 = hn::InterleaveLower(kTag, v.z, v.w);
  const V ab23 = hn::InterleaveUpper(kTag, v.x, v.y), cd23 = hn::InterleaveUpper(kTag, v.z, v.w);
  // Of the interleaved, the lower halves are of lanes 0 and 1, the upper ones of 2 and 3.
  hn::Store(hn::ConcatLowerLower(kTag, cd01, ab01), kTag, at(0));
  hn::Store(hn::ConcatLowerLower(kTag, cd23, ab23), kTag, at(1));
  hn::Store(hn::ConcatUpperUpper(kTag, cd01, ab01), kTag, at(2));
  hn::Store(hn::ConcatUpperUpper(kTag, cd23, ab23), kTag, at(3));
#else
  HWY_ALIGN double part[4][kLanes];
  hn::Store(v.x, kTag, part[0]);
  hn::Store(v.y, kTag, part[1]);
  hn::Store(v.z, kTag, part[2]);
  hn::Store(v.w, kTag, part[3]);
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t k = 0; k < 4; ++k) at(lane)[k] = part[k][lane];
#endif
}

HWY_INLINE V4 loadPlaces(const Place* places, const std::uint32_t* index) {
  return loadQuads([&](std::size_t lane) { return &places[index[lane]].x; });
}
HWY_INLINE void storePlaces(const V4& v, Place* places, const std::uint32_t* index) {
  storeQuads(v, [&](std::size_t lane) { return &places[index[lane]].x; });
}

/// Velocity and inverse mass; surface speed.
struct Moving {
  V4 v;
  V4 s;
};

template <bool kSpins>
HWY_INLINE Moving loadMoving(const Momentum* momenta, const std::uint32_t* index) {
  Moving moving;
  moving.v = loadQuads([&](std::size_t lane) { return &momenta[index[lane]].vx; });
  if constexpr (kSpins)
    moving.s = loadQuads([&](std::size_t lane) { return &momenta[index[lane]].sx; });
  else
    moving.s = moving.v;
  return moving;
}
template <bool kSpins>
HWY_INLINE void storeMoving(const Moving& moving, Momentum* momenta, const std::uint32_t* index) {
  storeQuads(moving.v, [&](std::size_t lane) { return &momenta[index[lane]].vx; });
  if constexpr (kSpins)
    storeQuads(moving.s, [&](std::size_t lane) { return &momenta[index[lane]].sx; });
}

HWY_INLINE V3 normalOf(const ContactBlock& block, std::size_t lane) {
  return {load(block.nx + lane), load(block.ny + lane), load(block.nz + lane)};
}
HWY_INLINE V3 tangentOf(const ContactBlock& block, std::size_t lane) {
  return {load(block.tx + lane), load(block.ty + lane), load(block.tz + lane)};
}

/// Gives a the impulse, and b the opposite.
template <PartnerKind kPartner>
HWY_INLINE void push(const V3& impulse, Moving& a, Moving& b) {
  const V3 va = xyz(a.v) + scaled(a.v.w, impulse);
  a.v = {va.x, va.y, va.z, a.v.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 vb = xyz(b.v) - scaled(b.v.w, impulse);
  b.v = {vb.x, vb.y, vb.z, b.v.w};
}

/// What a tangent impulse, given by push(), does to the spins: the same to both.
template <PartnerKind kPartner>
HWY_INLINE void twist(const V3& normal, const V3& tangent, Moving& a, Moving& b) {
  const V3 torque = scaled(set(kSpinFactor), cross(normal, tangent));
  const V3 sa = xyz(a.s) + scaled(a.v.w, torque);
  a.s = {sa.x, sa.y, sa.z, a.s.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 sb = xyz(b.s) + scaled(b.v.w, torque);
  b.s = {sb.x, sb.y, sb.z, b.s.w};
}

struct Geometry {
  V3 across;  // m; in whose direction the normal lies
  V distance;
  V gap;
  V touching;  // m, the distance at which the gap is 0
};

/// Of a ball and the partner.
template <PartnerKind kPartner>
HWY_INLINE Geometry geometryOf(const Arena& arena, const V4& a, const V4& b) {
  if constexpr (kPartner == PartnerKind::Ball) {
    const V3 d = xyz(b) - xyz(a);
    const V touching = hn::Add(a.w, b.w);
    const V distance = hn::Sqrt(dot(d, d));
    return {d, distance, hn::Sub(distance, touching), touching};
  } else if constexpr (kPartner == PartnerKind::Ground) {
    const V height = hn::Sub(a.y, set(arena.center.y()));
    return {{set(0), set(-1), set(0)}, set(1), hn::Sub(height, a.w), a.w};
  } else {
    const V x = hn::Sub(a.x, set(arena.center.x()));
    const V z = hn::Sub(a.z, set(arena.center.z()));
    const V distance = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(z, z)));
    const V touching = hn::Sub(set(arena.radius), a.w);
    return {{x, set(0), z}, distance, hn::Sub(touching, distance), touching};
  }
}

/// Across divided by its length; +x where that is 0, which the caller mends for balls.
HWY_INLINE V3 directionOf(const V3& across, V size) {
  const M isNull = hn::Eq(size, set(0));
  const V3 direction = scaled(hn::Div(set(1), hn::IfThenElse(isNull, set(1), size)), across);
  return choose(isNull, {set(1), set(0), set(0)}, direction);
}

template <PartnerKind kPartner>
std::size_t touchingOf(const CrowdRules& rules, const CrowdArrays& in, std::uint32_t first,
                       std::uint32_t last, std::uint32_t* touching) {
  std::size_t count = 0;
  for (std::uint32_t p = first; p < last; p += kLanes) {
    std::uint32_t a[kLanes], b[kLanes];
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      const IndexPair& pair = in.pairs[std::min(p + lane, last - 1)];
      a[lane] = pair.a;
      b[lane] = pair.b;
    }
    const V4 placeA = loadPlaces(in.place, a);
    HWY_ALIGN double gap[kLanes];
    if constexpr (kPartner == PartnerKind::Ball) {
      // Squares will do.
      const V4 placeB = loadPlaces(in.place, b);
      const V3 d = xyz(placeB) - xyz(placeA);
      const V reach = hn::Add(placeA.w, placeB.w);
      hn::Store(hn::Sub(dot(d, d), hn::Mul(reach, reach)), kTag, gap);
    } else {
      hn::Store(geometryOf<kPartner>(rules.arena, placeA, placeA).gap, kTag, gap);
    }
    // Without a branch for each: whether a pair touches cannot be foretold.
    const auto lanes = std::min<std::uint32_t>(kLanes, last - p);
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
      touching[count] = p + lane;
      count += gap[lane] <= 0 ? 1 : 0;
    }
  }
  return count;
}

/// The normals of balls whose centres coincide.
HWY_NOINLINE V3 normalsOfIds(const CrowdArrays& in, const V3& normal, V distance,
                             const std::uint32_t* a, const std::uint32_t* b) {
  HWY_ALIGN double part[4][kLanes];
  hn::Store(normal.x, kTag, part[0]);
  hn::Store(normal.y, kTag, part[1]);
  hn::Store(normal.z, kTag, part[2]);
  hn::Store(distance, kTag, part[3]);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (part[3][lane] > 0) continue;
    const Vec3 direction = directionOfIds(in.ids[a[lane]], in.ids[b[lane]]);
    for (int k = 0; k < 3; ++k) part[k][lane] = direction[k];
  }
  return {load(part[0]), load(part[1]), load(part[2])};
}

/// Speed along the normal, either way.
HWY_INLINE V speedAlong(const V3& velocity, const V3& normal) {
  return hn::Abs(dot(velocity, normal));
}

template <PartnerKind kPartner>
HWY_INLINE V3 acrossRate(const V3& va, const V3& vb) {
  if constexpr (kPartner == PartnerKind::Ball) return vb - va;
  if constexpr (kPartner == PartnerKind::Ground) return {set(0), set(0), set(0)};
  return {va.x, set(0), va.z};
}

template <PartnerKind kPartner, bool kRubs>
void prepareLanes(const CrowdRules& rules, const CrowdArrays& in, std::size_t lane,
                  ContactBlock& block, ContactFlight& flight, CrowdSubstep& substep) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  const V zero = set(0);
  const std::uint32_t* const a = block.a + lane;
  const std::uint32_t* const b = block.b + lane;
  const V4 placeA = loadPlaces(in.place, a);
  const V4 placeB = kIsBall ? loadPlaces(in.place, b) : placeA;
  const auto flownOf = [&](const std::uint32_t* index) {
    return xyz(loadQuads([&](std::size_t l) { return &in.flown[index[l]].vx; }));
  };
  const auto gainedOf = [&](const std::uint32_t* index) {
    return xyz(loadQuads([&](std::size_t l) { return &in.flown[index[l]].gx; }));
  };
  const V3 none{zero, zero, zero};
  const V3 va = flownOf(a);
  const V3 ga = gainedOf(a);
  const V3 vb = kIsBall ? flownOf(b) : none;
  const V3 gb = kIsBall ? gainedOf(b) : none;

  const Geometry now = geometryOf<kPartner>(rules.arena, placeA, placeB);
  V3 normal = directionOf(now.across, now.distance);
  if (kIsBall && !hn::AllFalse(kTag, hn::Eq(now.distance, zero)))
    normal = normalsOfIds(in, normal, now.distance, a, b);

  // Forces explain so much of how fast it closes.
  const V pulled =
      kIsBall ? hn::Max(speedAlong(ga, normal), speedAlong(gb, normal)) : speedAlong(ga, normal);
  const M isImpact = hn::Gt(dot(va - vb, normal), hn::Mul(set(kRestFactor), pulled));
  const V fall = hn::Mul(pulled, set(rules.h / 2));
  const M isCoarse = hn::Gt(fall, hn::Mul(set(kNear), placeA.w));

  HWY_ALIGN double wasTouching[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    std::uint32_t& touched = in.touchedIn[block.pair[lane + l]];
    wasTouching[l] = touched + 1 == rules.substep ? 1 : 0;
    touched = rules.substep;
  }
  const V4 old = loadQuads([&](std::size_t l) { return &in.lasting[block.pair[lane + l]].normal; });
  const M isWarm = hn::AndNot(isImpact, hn::Gt(hn::Mul(load(wasTouching), old.x), zero));

  // The normal half-way through the substep, where what lasts acted on the mean: what rolls over
  // another ball keeps its energy to second order.
  const M rests = hn::AndNot(isCoarse, hn::Gt(hn::Mul(load(wasTouching), old.x), zero));
  const V3 middle = now.across - scaled(set(rules.h / 2), acrossRate<kPartner>(va, vb));
  const V middleSize = hn::Sqrt(dot(middle, middle));
  normal =
      choose(hn::And(rests, hn::Gt(middleSize, zero)), directionOf(middle, middleSize), normal);

  const V closing = dot(va - vb, normal);
  const V builtUp = dot(ga - gb, normal);
  // What turns parts at the start as fast as it closes at the end.
  const V turning = hn::Min(zero, hn::Sub(closing, builtUp));
  const V bounce = hn::IfThenElse(isImpact, hn::Mul(set(rules.elasticity), closing),
                                  hn::IfThenElseZero(rests, turning));

  Moving movingA = loadMoving<kRubs>(in.momentum, a);
  Moving movingB = kIsBall ? loadMoving<kRubs>(in.momentum, b) : movingA;
  const V inverseMasses = kIsBall ? hn::Add(movingA.v.w, movingB.v.w) : movingA.v.w;
  const V normalImpulse = hn::IfThenElseZero(isWarm, old.x);
  V3 tangent = none;
  if constexpr (kRubs) {
    tangent = choose(isWarm, {old.y, old.z, old.w}, none);
    tangent = tangent - scaled(dot(tangent, normal), normal);  // the normal has turned
  }
  if (!hn::AllFalse(kTag, isWarm)) {
    push<kPartner>(tangent - scaled(normalImpulse, normal), movingA, movingB);
    if constexpr (kRubs) twist<kPartner>(normal, tangent, movingA, movingB);
    storeMoving<kRubs>(movingA, in.momentum, a);
    if constexpr (kIsBall) storeMoving<kRubs>(movingB, in.momentum, b);
  }

  const auto store = [&](V v, double* to) { hn::Store(v, kTag, to + lane); };
  store(normal.x, block.nx);
  store(normal.y, block.ny);
  store(normal.z, block.nz);
  store(hn::Div(set(1), inverseMasses), block.mass);
  store(bounce, block.bounce);
  store(normalImpulse, block.normal);
  store(tangent.x, block.tx);
  store(tangent.y, block.ty);
  store(tangent.z, block.tz);
  store(now.gap, flight.gap);
  store(closing, flight.closing);
  store(builtUp, flight.builtUp);
  store(hn::IfThenElse(isImpact, zero, set(1)), flight.lasts);
  store(hn::IfThenElse(isCoarse, zero, set(1)), flight.rubShifts);
  substep.anyImpact = substep.anyImpact || !hn::AllFalse(kTag, isImpact);
  substep.builtUp = std::max(substep.builtUp, hn::GetLane(hn::MaxOfLanes(kTag, builtUp)));
}

template <PartnerKind kPartner, bool kRubs>
void prepareAll(const CrowdRules& rules, const CrowdArrays& in,
                std::span<const std::uint32_t> touching, ContactBlock* blocks,
                ContactFlight* flights, CrowdSubstep& substep) {
  for (std::size_t first = 0; first < touching.size(); first += kContactLanes) {
    ContactBlock& block = blocks[first / kContactLanes];
    block.count = static_cast<std::uint32_t>(std::min(kContactLanes, touching.size() - first));
    for (std::size_t lane = 0; lane < kContactLanes; ++lane) {
      const bool isUsed = lane < block.count;
      const std::uint32_t p = isUsed ? touching[first + lane] : in.idlePair;
      block.pair[lane] = p;
      block.a[lane] = isUsed ? in.pairs[p].a : in.idleBall;
      block.b[lane] = isUsed ? in.pairs[p].b : in.idleBall + 1;
    }
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes)
      prepareLanes<kPartner, kRubs>(rules, in, lane, block, flights[first / kContactLanes],
                                    substep);
  }
}

template <PartnerKind kPartner, bool kRubs, bool kWatches>
double solveAll(const CrowdRules& rules, const CrowdArrays& in, std::span<ContactBlock> blocks) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  const V friction = set(rules.friction);
  V most = set(0);
  for (ContactBlock& block : blocks) {
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes) {
      Moving a = loadMoving<kRubs>(in.momentum, block.a + lane);
      Moving b = kIsBall ? loadMoving<kRubs>(in.momentum, block.b + lane) : a;
      const V3 normal = normalOf(block, lane);
      const V mass = load(block.mass + lane);
      const V3 relative = kIsBall ? xyz(a.v) - xyz(b.v) : xyz(a.v);
      const V closing = dot(relative, normal);
      const V before = load(block.normal + lane);
      const V wanted = hn::Mul(mass, hn::Add(closing, load(block.bounce + lane)));
      const V total = hn::Max(set(0), hn::Add(before, wanted));
      const V change = hn::Sub(total, before);
      hn::Store(total, kTag, block.normal + lane);
      if constexpr (kWatches) most = hn::Max(most, hn::Div(hn::Abs(change), mass));
      if constexpr (!kRubs) {
        push<kPartner>(scaled(hn::Neg(change), normal), a, b);
      } else {
        // What the normal impulse changes is no slip.
        const V3 turning = kIsBall ? xyz(a.s) + xyz(b.s) : xyz(a.s);
        const V3 slip = relative + cross(turning, normal) - scaled(closing, normal);
        const V tangentMass = hn::Mul(mass, set(1 / (1 + kSpinFactor)));
        const V3 old = tangentOf(block, lane);
        V3 rub = old - scaled(tangentMass, slip);
        const V limit = hn::Mul(friction, total);
        const V size = dot(rub, rub);
        const M slides = hn::Gt(size, hn::Mul(limit, limit));
        if (!hn::AllFalse(kTag, slides))
          rub = choose(slides, scaled(hn::Div(limit, hn::Sqrt(size)), rub), rub);
        const V3 rubbed = rub - old;
        hn::Store(rub.x, kTag, block.tx + lane);
        hn::Store(rub.y, kTag, block.ty + lane);
        hn::Store(rub.z, kTag, block.tz + lane);
        if constexpr (kWatches)
          most = hn::Max(most, hn::Div(hn::Sqrt(dot(rubbed, rubbed)), tangentMass));
        push<kPartner>(rubbed - scaled(change, normal), a, b);
        twist<kPartner>(normal, rubbed, a, b);
      }
      storeMoving<kRubs>(a, in.momentum, block.a + lane);
      if constexpr (kIsBall) storeMoving<kRubs>(b, in.momentum, block.b + lane);
    }
  }
  return kWatches ? hn::GetLane(hn::MaxOfLanes(kTag, most)) : 0;
}

/// Moves a against the normal and b along it, each by its inverse mass.
template <PartnerKind kPartner>
HWY_INLINE void move(const V3& byMass, V inverseA, V inverseB, V4& a, V4& b) {
  const V3 placeA = xyz(a) + scaled(inverseA, byMass);
  a = {placeA.x, placeA.y, placeA.z, a.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 placeB = xyz(b) - scaled(inverseB, byMass);
  b = {placeB.x, placeB.y, placeB.z, b.w};
}

/// As lasting_force.h has it, for contacts alone.
template <PartnerKind kPartner>
void shiftAll(const CrowdRules& rules, const CrowdArrays& in, std::span<const ContactBlock> blocks,
              const ContactFlight* flights) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  const V zero = set(0);
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    const ContactBlock& block = blocks[n];
    const ContactFlight& flight = flights[n];
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes) {
      const V lasts = load(flight.lasts + lane);
      const V impulse = load(block.normal + lane);
      const V3 tangent = tangentOf(block, lane);
      storeQuads({hn::Mul(lasts, impulse), tangent.x, tangent.y, tangent.z},
                 [&](std::size_t l) { return &in.lasting[block.pair[lane + l]].normal; });
      const M acts = hn::Gt(hn::Mul(lasts, impulse), zero);
      if (hn::AllFalse(kTag, acts)) continue;
      const Moving a = loadMoving<false>(in.momentum, block.a + lane);
      const Moving b = kIsBall ? loadMoving<false>(in.momentum, block.b + lane) : a;
      const V3 normal = normalOf(block, lane);
      const V resolved = dot(kIsBall ? xyz(a.v) - xyz(b.v) : xyz(a.v), normal);
      const V builtUp = load(flight.builtUp + lane);
      const M isBuiltUp = hn::Gt(builtUp, zero);
      const V part = hn::Div(hn::Add(load(flight.closing + lane), resolved),
                             hn::IfThenElse(isBuiltUp, builtUp, set(1)));
      const V clamped = hn::Min(set(1), hn::Max(zero, part));
      const V share = hn::IfThenElseZero(acts, hn::IfThenElse(isBuiltUp, clamped, set(1)));
      const V3 rub = scaled(load(flight.rubShifts + lane), tangent);
      const V3 byMass = scaled(hn::Mul(share, set(rules.h / 2)), rub - scaled(impulse, normal));
      V4 placeA = loadPlaces(in.place, block.a + lane);
      V4 placeB = kIsBall ? loadPlaces(in.place, block.b + lane) : placeA;
      move<kPartner>(byMass, a.v.w, b.v.w, placeA, placeB);
      storePlaces(placeA, in.place, block.a + lane);
      if constexpr (kIsBall) storePlaces(placeB, in.place, block.b + lane);
    }
  }
}

template <PartnerKind kPartner>
void pushOutAll(const CrowdRules& rules, const CrowdArrays& in,
                std::span<const ContactBlock> blocks) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  constexpr double kShare = kIsBall ? kPushOut : kPushOutOfArena;
  const V zero = set(0);
  for (const ContactBlock& block : blocks) {
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes) {
      V4 placeA = loadPlaces(in.place, block.a + lane);
      V4 placeB = kIsBall ? loadPlaces(in.place, block.b + lane) : placeA;
      const Geometry now = geometryOf<kPartner>(rules.arena, placeA, placeB);
      const V overlap = hn::Neg(now.gap);
      if (hn::AllFalse(kTag, hn::Gt(overlap, zero))) continue;
      V3 normal = directionOf(now.across, now.distance);
      if (kIsBall && !hn::AllFalse(kTag, hn::Eq(now.distance, zero)))
        normal = normalsOfIds(in, normal, now.distance, block.a + lane, block.b + lane);
      const Moving a = loadMoving<false>(in.momentum, block.a + lane);
      const Moving b = kIsBall ? loadMoving<false>(in.momentum, block.b + lane) : a;
      const V parting = hn::Neg(dot(kIsBall ? xyz(a.v) - xyz(b.v) : xyz(a.v), normal));
      const V leaving = hn::Mul(hn::Max(zero, parting), set(rules.h));
      const V left = hn::Mul(set(kLeftOverlap), hn::Min(placeA.w, placeB.w));
      V depth = hn::Sub(hn::Sub(overlap, leaving), left);
      // However fast it leaves, a centre does not stay outside.
      if constexpr (!kIsBall)
        depth = hn::Max(depth, hn::Sub(overlap, hn::Mul(set(kDeepestInArena), placeA.w)));
      depth = hn::Max(zero, depth);
      const V byMass = hn::Mul(hn::Mul(set(-kShare), depth), load(block.mass + lane));
      move<kPartner>(scaled(byMass, normal), a.v.w, b.v.w, placeA, placeB);
      storePlaces(placeA, in.place, block.a + lane);
      if constexpr (kIsBall) storePlaces(placeB, in.place, block.b + lane);
    }
  }
}

/// Calls action.template operator()<kPartner>().
template <class Action>
auto withKind(PartnerKind partner, Action action) {
  switch (partner) {
    case PartnerKind::Ground:
      return action.template operator()<PartnerKind::Ground>();
    case PartnerKind::Wall:
      return action.template operator()<PartnerKind::Wall>();
    case PartnerKind::Ball:
      break;
  }
  return action.template operator()<PartnerKind::Ball>();
}

std::size_t touching(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
                     std::uint32_t first, std::uint32_t last, std::uint32_t* list) {
  return withKind(partner, [&]<PartnerKind kPartner>() {
    return touchingOf<kPartner>(rules, in, first, last, list);
  });
}

void prepare(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
             std::span<const std::uint32_t> list, ContactBlock* blocks, ContactFlight* flights,
             CrowdSubstep& substep) {
  withKind(partner, [&]<PartnerKind kPartner>() {
    if (rules.friction > 0)
      prepareAll<kPartner, true>(rules, in, list, blocks, flights, substep);
    else
      prepareAll<kPartner, false>(rules, in, list, blocks, flights, substep);
  });
}

double solve(PartnerKind partner, Watch watch, const CrowdRules& rules, const CrowdArrays& in,
             std::span<ContactBlock> blocks) {
  return withKind(partner, [&]<PartnerKind kPartner>() {
    if (watch == Watch::Changes)
      return rules.friction > 0 ? solveAll<kPartner, true, true>(rules, in, blocks)
                                : solveAll<kPartner, false, true>(rules, in, blocks);
    return rules.friction > 0 ? solveAll<kPartner, true, false>(rules, in, blocks)
                              : solveAll<kPartner, false, false>(rules, in, blocks);
  });
}

void shift(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
           std::span<const ContactBlock> blocks, const ContactFlight* flights) {
  withKind(partner,
           [&]<PartnerKind kPartner>() { shiftAll<kPartner>(rules, in, blocks, flights); });
}

void pushOut(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
             std::span<const ContactBlock> blocks) {
  withKind(partner, [&]<PartnerKind kPartner>() { pushOutAll<kPartner>(rules, in, blocks); });
}

}  // namespace
}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(touching);
HWY_EXPORT(prepare);
HWY_EXPORT(solve);
HWY_EXPORT(shift);
HWY_EXPORT(pushOut);

std::size_t findTouching(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                         std::uint32_t first, std::uint32_t last, std::uint32_t* list) {
  return HWY_DYNAMIC_DISPATCH(touching)(partner, rules, arrays, first, last, list);
}

void prepareContacts(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                     std::span<const std::uint32_t> list, ContactBlock* blocks,
                     ContactFlight* flights, CrowdSubstep& substep) {
  HWY_DYNAMIC_DISPATCH(prepare)(partner, rules, arrays, list, blocks, flights, substep);
}

double solveContacts(PartnerKind partner, Watch watch, const CrowdRules& rules,
                     const CrowdArrays& arrays, std::span<ContactBlock> blocks) {
  return HWY_DYNAMIC_DISPATCH(solve)(partner, watch, rules, arrays, blocks);
}

void shiftByForces(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                   std::span<const ContactBlock> blocks, const ContactFlight* flights) {
  HWY_DYNAMIC_DISPATCH(shift)(partner, rules, arrays, blocks, flights);
}

void pushOverlapsOut(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                     std::span<const ContactBlock> blocks) {
  HWY_DYNAMIC_DISPATCH(pushOut)(partner, rules, arrays, blocks);
}

}  // namespace wells
#endif  // HWY_ONCE
