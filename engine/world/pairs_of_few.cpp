#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/pairs_of_few.cpp"
#include <hwy/foreach_target.h>

#include <bit>
#include <limits>

#include "math/wide_vector-inl.h"
#include "world/pairs_of_few.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

/// Writes those of sphere n with later ones from `pairs` on; returns their end.
BallPair* pairsOf(const FewSpheres& all, std::size_t n, BallPair* pairs) {
  const hn::ScalableTag<double> d;
  const auto center = wide(d, all.x[n], all.y[n], all.z[n]);
  const auto radius = hn::Set(d, all.radius[n]);
  const auto largest = hn::Set(d, std::numeric_limits<double>::max());
  for (std::size_t m = n + 1; m < all.count; m += hn::Lanes(d)) {
    const auto apart = load(d, &all.x[m], &all.y[m], &all.z[m]) - center;
    const auto bound = radius + hn::LoadU(d, &all.radius[m]);
    const auto overlaps = hn::And(squaredLength(apart) <= bound * bound, bound <= largest);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, overlaps, bits);
    for (unsigned left = bits[0]; left != 0; left &= left - 1) {
      const std::size_t other = m + static_cast<std::size_t>(std::countr_zero(left));
      if (other < all.count) *pairs++ = {all.id[n], all.id[other]};
    }
  }
  return pairs;
}

std::size_t pairsOfAll(const FewSpheres& all, BallPair* pairs) {
  BallPair* end = pairs;
  for (std::size_t n = 0; n + 1 < all.count; ++n) end = pairsOf(all, n, end);
  return static_cast<std::size_t>(end - pairs);
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(pairsOfAll);

void findPairsOfFew(const FewSpheres& spheres, std::vector<BallPair>& pairs) {
  pairs.resize(spheres.count * spheres.count / 2);
  pairs.resize(HWY_DYNAMIC_DISPATCH(pairsOfAll)(spheres, pairs.data()));
}

}  // namespace wells
#endif
