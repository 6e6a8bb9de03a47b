#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contacts/crowd_prepare.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "contacts/contact_lanes-inl.h"
#include "contacts/substep_rules.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

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

/// CrowdSubstep, lane by lane.
struct Lasting {
  M anyImpact;
  V closing;
};

template <PartnerKind kPartner, bool kRubs>
void prepareLanes(const CrowdRules& rules, const CrowdArrays& in, std::size_t lane,
                  ContactBlock& block, ContactFlight& flight, Lasting& most) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  const V zero = set(0);
  const std::uint32_t* const a = block.a + lane;
  const std::uint32_t* const b = block.b + lane;
  const V4 placeA = loadPlaces(in.place, a);
  const V4 placeB = kIsBall ? loadPlaces(in.place, b) : placeA;
  const auto gainedOf = [&](const std::uint32_t* index) {
    return xyz(loadQuads([&](std::size_t l) { return &in.gained[index[l]].vx; }));
  };
  const V3 none{zero, zero, zero};
  const Moving movingA = loadMoving<false>(in.momentum, a);
  const Moving movingB = kIsBall ? loadMoving<false>(in.momentum, b) : movingA;
  const V3 va = xyz(movingA.v);
  const V3 ga = gainedOf(a);
  const V3 vb = kIsBall ? xyz(movingB.v) : none;
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
  const V3 middle = now.across - scaled(acrossRate<kPartner>(va, vb), set(rules.h / 2));
  const V middleSize = hn::Sqrt(dot(middle, middle));
  normal =
      choose(hn::And(rests, hn::Gt(middleSize, zero)), directionOf(middle, middleSize), normal);

  const V closing = dot(va - vb, normal);
  const V builtUp = dot(ga - gb, normal);
  // What turns parts at the start as fast as it closes at the end.
  const V turning = hn::Min(zero, hn::Sub(closing, builtUp));
  const V bounce = hn::IfThenElse(isImpact, hn::Mul(set(rules.elasticity), closing),
                                  hn::IfThenElseZero(rests, turning));

  const V inverseMasses = kIsBall ? hn::Add(movingA.v.w, movingB.v.w) : movingA.v.w;
  const V normalImpulse = hn::IfThenElseZero(isWarm, old.x);
  V3 tangent = none;
  if constexpr (kRubs) {
    tangent = choose(isWarm, {old.y, old.z, old.w}, none);
    tangent = tangent - scaled(normal, dot(tangent, normal));  // the normal has turned
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
  most.anyImpact = hn::Or(most.anyImpact, isImpact);
  most.closing = hn::Max(most.closing, hn::IfThenElse(isImpact, closing, builtUp));
}

template <PartnerKind kPartner, bool kRubs>
void prepareAll(const CrowdRules& rules, const CrowdArrays& in,
                std::span<const std::uint32_t> touching, ContactBlock* blocks,
                ContactFlight* flights, CrowdSubstep& substep) {
  Lasting most{hn::FirstN(kTag, 0), set(0)};
  for (std::size_t first = 0; first < touching.size(); first += kContactLanes) {
    ContactBlock& block = blocks[first / kContactLanes];
    block.count = static_cast<std::uint32_t>(std::min(kContactLanes, touching.size() - first));
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      const std::uint32_t p = block.pair[lane] = touching[first + lane];
      block.a[lane] = in.pairs[p].a;
      block.b[lane] = in.pairs[p].b;
    }
    for (std::size_t lane = block.count; lane < kContactLanes; ++lane) {
      block.pair[lane] = in.idlePair;
      block.a[lane] = in.idleBall;
      block.b[lane] = in.idleBall + 1;
    }
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes)
      prepareLanes<kPartner, kRubs>(rules, in, lane, block, flights[first / kContactLanes], most);
  }
  substep.anyImpact = substep.anyImpact || !hn::AllFalse(kTag, most.anyImpact);
  substep.closing = std::max(substep.closing, hn::GetLane(hn::MaxOfLanes(kTag, most.closing)));
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

}  // namespace
}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(prepare);

void prepareContacts(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                     std::span<const std::uint32_t> list, ContactBlock* blocks,
                     ContactFlight* flights, CrowdSubstep& substep) {
  HWY_DYNAMIC_DISPATCH(prepare)(partner, rules, arrays, list, blocks, flights, substep);
}

}  // namespace wells
#endif  // HWY_ONCE
