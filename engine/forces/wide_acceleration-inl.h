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

/// m/s^2 at `position` (m), `t` seconds after the start of the step.
template <class D>
HWY_INLINE WideVector<D> acceleration(const Field& field, const WideVector<D>& position, double t) {
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
