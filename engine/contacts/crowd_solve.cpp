#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contacts/crowd_solve.cpp"
#include <hwy/foreach_target.h>

#include "contacts/contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

template <PartnerKind kPartner, bool kRubs>
void warmStartAll(const CrowdArrays& in, std::span<const ContactBlock> blocks) {
  constexpr bool kIsBall = kPartner == PartnerKind::Ball;
  for (const ContactBlock& block : blocks) {
    for (std::size_t lane = 0; lane < kContactLanes; lane += kLanes) {
      const V impulse = load(block.normal + lane);
      if (hn::AllFalse(kTag, hn::Gt(impulse, set(0)))) continue;
      Moving a = loadMoving<kRubs>(in.momentum, block.a + lane);
      Moving b = kIsBall ? loadMoving<kRubs>(in.momentum, block.b + lane) : a;
      const V3 normal = normalOf(block, lane);
      const V3 tangent = tangentOf(block, lane);
      push<kPartner>(tangent - scaled(normal, impulse), a, b);
      if constexpr (kRubs) twist<kPartner>(normal, tangent, a, b);
      storeMoving<kRubs>(a, in.momentum, block.a + lane);
      if constexpr (kIsBall) storeMoving<kRubs>(b, in.momentum, block.b + lane);
    }
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
        push<kPartner>(scaled(normal, hn::Neg(change)), a, b);
      } else {
        // What the normal impulse changes is no slip.
        const V3 turning = kIsBall ? xyz(a.s) + xyz(b.s) : xyz(a.s);
        const V3 slip = relative + cross(turning, normal) - scaled(normal, closing);
        const V tangentMass = hn::Mul(mass, set(1 / (1 + kSpinFactor)));
        const V3 old = tangentOf(block, lane);
        V3 rub = old - scaled(slip, tangentMass);
        const V limit = hn::Mul(friction, total);
        const V size = dot(rub, rub);
        const M slides = hn::Gt(size, hn::Mul(limit, limit));
        if (!hn::AllFalse(kTag, slides))
          rub = choose(slides, scaled(rub, hn::Div(limit, hn::Sqrt(size))), rub);
        const V3 rubbed = rub - old;
        hn::Store(rub.x, kTag, block.tx + lane);
        hn::Store(rub.y, kTag, block.ty + lane);
        hn::Store(rub.z, kTag, block.tz + lane);
        if constexpr (kWatches)
          most = hn::Max(most, hn::Div(hn::Sqrt(dot(rubbed, rubbed)), tangentMass));
        push<kPartner>(rubbed - scaled(normal, change), a, b);
        twist<kPartner>(normal, rubbed, a, b);
      }
      storeMoving<kRubs>(a, in.momentum, block.a + lane);
      if constexpr (kIsBall) storeMoving<kRubs>(b, in.momentum, block.b + lane);
    }
  }
  return kWatches ? hn::GetLane(hn::MaxOfLanes(kTag, most)) : 0;
}

void warmStart(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
               std::span<const ContactBlock> blocks) {
  withKind(partner, [&]<PartnerKind kPartner>() {
    if (rules.friction > 0)
      warmStartAll<kPartner, true>(in, blocks);
    else
      warmStartAll<kPartner, false>(in, blocks);
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

}  // namespace
}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(warmStart);
HWY_EXPORT(solve);

void startFromLasting(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                      std::span<const ContactBlock> blocks) {
  HWY_DYNAMIC_DISPATCH(warmStart)(partner, rules, arrays, blocks);
}

double solveContacts(PartnerKind partner, Watch watch, const CrowdRules& rules,
                     const CrowdArrays& arrays, std::span<ContactBlock> blocks) {
  return HWY_DYNAMIC_DISPATCH(solve)(partner, watch, rules, arrays, blocks);
}

}  // namespace wells
#endif  // HWY_ONCE
