#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "forces/pull_bound.cpp"
#include <hwy/foreach_target.h>

#include "forces/pull_bound.h"
#include "math/wide_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

/// By each well of a block.
template <class D>
HWY_INLINE hn::Vec<D> boundOfEach(D w, const WellBlock& block, std::size_t i,
                                  const WideVector<D>& position, double speed, double t,
                                  double duration) {
  const auto row = [&](const WellBlock::Row& of) HWY_ATTR { return hn::LoadU(w, of.data() + i); };
  const WideVector<D> start = {row(block.x), row(block.y), row(block.z)};
  const WideVector<D> velocity = {row(block.vx), row(block.vy), row(block.vz)};
  const auto e2 = row(block.softeningSquared);
  const auto distance = length(start + velocity * t - position);
  const auto way = (hn::Set(w, speed) + row(block.speed)) * hn::Set(w, duration);
  const auto zero = hn::Zero(w);
  const auto two = hn::Set(w, 2.0);
  const auto least = distance - way;
  const auto most = distance + way;
  const auto isOutside = hn::And(least > zero, two * least * least > e2);
  const auto isInside = two * most * most < e2;
  const auto worst = hn::IfThenElse(isOutside, least, hn::IfThenElseZero(isInside, most));
  const auto s2 = worst * worst + e2;
  const auto pull = hn::Abs(row(block.strength)) * worst / (s2 * hn::Sqrt(s2));
  return hn::IfThenElse(worst == zero, row(block.strongest), pull);
}

double pullBound(const Field& field, const Vec3& position, double speed, double t,
                 double duration) {
  const hn::CappedTag<double, WellBlock::kSize> w;
  const auto at = wide(w, position.x(), position.y(), position.z());
  double sum = 0;
  for (const WellBlock& block : field.wells.blocks()) {
    WellBlock::Row bound;
    for (std::size_t i = 0; i < WellBlock::kSize; i += hn::Lanes(w))
      hn::StoreU(boundOfEach(w, block, i, at, speed, t, duration), w, bound.data() + i);
    for (std::size_t k = 0; k < block.count; ++k) sum += bound[k];
  }
  return sum;
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(pullBound);

double pullBound(const Field& field, const Vec3& position, double speed, double t,
                 double duration) {
  return HWY_DYNAMIC_DISPATCH(pullBound)(field, position, speed, t, duration);
}

}  // namespace wells
#endif
