#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contacts/crowd_move.cpp"
#include <hwy/foreach_target.h>

#include "contacts/contact_lanes-inl.h"
#include "contacts/substep_rules.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

/// Moves a against the normal and b along it, each by its inverse mass.
template <PartnerKind kPartner>
HWY_INLINE void move(const V3& byMass, V inverseA, V inverseB, V4& a, V4& b) {
  const V3 placeA = xyz(a) + scaled(byMass, inverseA);
  a = {placeA.x, placeA.y, placeA.z, a.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 placeB = xyz(b) - scaled(byMass, inverseB);
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
      const V3 rub = scaled(tangent, load(flight.rubShifts + lane));
      const V3 byMass = scaled(rub - scaled(normal, impulse), hn::Mul(share, set(rules.h / 2)));
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
      move<kPartner>(scaled(normal, byMass), a.v.w, b.v.w, placeA, placeB);
      storePlaces(placeA, in.place, block.a + lane);
      if constexpr (kIsBall) storePlaces(placeB, in.place, block.b + lane);
    }
  }
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

HWY_EXPORT(shift);
HWY_EXPORT(pushOut);

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
