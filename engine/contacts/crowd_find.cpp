#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contacts/crowd_find.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "contacts/contact_lanes-inl.h"
#include "contacts/substep_rules.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

/// Lane by lane, the balls of the pairs from `first` on; behind the last, the last one again.
struct LanesOfPairs {
  LanesOfPairs(const IndexPair* pairs, std::size_t first, std::size_t last) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const IndexPair& pair = pairs[std::min(first + lane, last - 1)];
      a[lane] = pair.a;
      b[lane] = pair.b;
    }
  }

  std::uint32_t a[kLanes], b[kLanes];
};

template <PartnerKind kPartner>
std::size_t touchingOf(const CrowdRules& rules, const CrowdArrays& in, std::uint32_t first,
                       std::uint32_t last, std::uint32_t* touching) {
  std::size_t count = 0;
  for (std::uint32_t p = first; p < last; p += kLanes) {
    const LanesOfPairs lanes(in.pairs, p, last);
    const V4 placeA = loadPlaces(in.place, lanes.a);
    HWY_ALIGN double gap[kLanes];
    if constexpr (kPartner == PartnerKind::Ball) {
      // Squares will do.
      const V4 placeB = loadPlaces(in.place, lanes.b);
      const V3 d = xyz(placeB) - xyz(placeA);
      const V reach = hn::Add(placeA.w, placeB.w);
      hn::Store(hn::Sub(dot(d, d), hn::Mul(reach, reach)), kTag, gap);
    } else {
      hn::Store(geometryOf<kPartner>(rules.arena, placeA, placeA).gap, kTag, gap);
    }
    // Without a branch for each: whether a pair touches cannot be foretold.
    const auto used = std::min<std::uint32_t>(kLanes, last - p);
    for (std::uint32_t lane = 0; lane < used; ++lane) {
      touching[count] = p + lane;
      count += gap[lane] <= 0 ? 1 : 0;
    }
  }
  return count;
}

std::size_t touching(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& in,
                     std::uint32_t first, std::uint32_t last, std::uint32_t* list) {
  return withKind(partner, [&]<PartnerKind kPartner>() {
    return touchingOf<kPartner>(rules, in, first, last, list);
  });
}

void near(double duration, const Place* places, const Momentum* momenta,
          std::span<const IndexPair> pairs, std::uint8_t* isNear) {
  for (std::size_t p = 0; p < pairs.size(); p += kLanes) {
    const LanesOfPairs lanes(pairs.data(), p, pairs.size());
    const V4 placeA = loadPlaces(places, lanes.a);
    const V4 placeB = loadPlaces(places, lanes.b);
    const V3 d = xyz(placeB) - xyz(placeA);
    const V3 v =
        xyz(loadMoving<false>(momenta, lanes.b).v) - xyz(loadMoving<false>(momenta, lanes.a).v);
    // Where they do not move on each other, 0 / 0 is not greater than 0 either.
    const V time = hn::Div(hn::Neg(dot(d, v)), dot(v, v));
    const V closest = hn::IfThenElseZero(hn::Gt(time, set(0)), hn::Min(time, set(duration)));
    const V3 then = d + scaled(v, closest);
    const V bound = hn::Mul(hn::Add(placeA.w, placeB.w), set(1 + kFarGap));
    HWY_ALIGN double beyond[kLanes];
    hn::Store(hn::Sub(dot(then, then), hn::Mul(bound, bound)), kTag, beyond);
    const std::size_t used = std::min(kLanes, pairs.size() - p);
    for (std::size_t lane = 0; lane < used; ++lane) isNear[p + lane] = beyond[lane] <= 0 ? 1 : 0;
  }
}

}  // namespace
}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(touching);
HWY_EXPORT(near);

std::size_t findTouching(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                         std::uint32_t first, std::uint32_t last, std::uint32_t* list) {
  return HWY_DYNAMIC_DISPATCH(touching)(partner, rules, arrays, first, last, list);
}

void findNear(double duration, const Place* places, const Momentum* momenta,
              std::span<const IndexPair> pairs, std::uint8_t* isNear) {
  HWY_DYNAMIC_DISPATCH(near)(duration, places, momenta, pairs, isNear);
}

}  // namespace wells
#endif  // HWY_ONCE
