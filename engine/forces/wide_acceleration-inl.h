// acceleration() of field.h for many balls at once; each lane has its bits.
//
// Included by sources that are compiled once for each instruction set (see
// math/instruction_set.h).
#if defined(WELLS_FORCES_WIDE_ACCELERATION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLS_FORCES_WIDE_ACCELERATION_INL_H_
#undef WELLS_FORCES_WIDE_ACCELERATION_INL_H_
#else
#define WELLS_FORCES_WIDE_ACCELERATION_INL_H_
#endif

#include "forces/field.h"
#include "math/wide_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

/// At one place: wells in the lanes, but their pulls are summed one after the other, as everywhere.
template <class D>
HWY_INLINE WideVector<D> accelerationAtOne(const Field& field, const WideVector<D>& position,
                                           double t) {
  static_assert(hn::MaxLanes(D()) == 1);
  const hn::CappedTag<double, WellBlock::kSize> w;
  const auto at =
      wide(w, hn::GetLane(position.x), hn::GetLane(position.y), hn::GetLane(position.z));
  const double* const g = field.gravity.data();
  WideVector<D> sum = wide(D(), g[0], g[1], g[2]);
  for (const WellBlock& block : field.wells.blocks()) {
    WellBlock::Row x, y, z;
    for (std::size_t i = 0; i < WellBlock::kSize; i += hn::Lanes(w)) {
      const auto start = load(w, block.x.data() + i, block.y.data() + i, block.z.data() + i);
      const auto velocity = load(w, block.vx.data() + i, block.vy.data() + i, block.vz.data() + i);
      const auto d = start + velocity * t - at;
      const auto s2 = squaredLength(d) + hn::LoadU(w, block.softeningSquared.data() + i);
      const auto pull = scaled(d, hn::LoadU(w, block.strength.data() + i) / (s2 * hn::Sqrt(s2)));
      store(pull, x.data() + i, y.data() + i, z.data() + i);
    }
    for (std::size_t k = 0; k < block.count; ++k)
      sum += load(D(), x.data() + k, y.data() + k, z.data() + k);
  }
  return sum;
}

/// m/s^2 at `position` (m), `t` seconds after the start of the step.
template <class D>
HWY_INLINE WideVector<D> acceleration(const Field& field, const WideVector<D>& position, double t) {
  if constexpr (hn::MaxLanes(D()) == 1) return accelerationAtOne(field, position, t);
  const D w;
  const double* const g = field.gravity.data();
  WideVector<D> sum = wide(w, g[0], g[1], g[2]);
  for (const Well& well : field.wells) {
    const double* const p = well.position.data();
    const double* const v = well.velocity.data();
    const WideVector<D> d = wide(w, p[0] + v[0] * t, p[1] + v[1] * t, p[2] + v[2] * t) - position;
    const auto s2 = squaredLength(d) + hn::Set(w, well.softening * well.softening);
    sum += scaled(d, hn::Set(w, well.strength) / (s2 * hn::Sqrt(s2)));
  }
  return sum;
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
