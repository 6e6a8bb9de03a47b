// Applies one integrator's formula to many balls, as many at a time as a vector has lanes.
//
// Included by the integrators, which are compiled once for each instruction set (see
// math/instruction_set.h).
#if defined(WELLS_FLIGHT_FLY_EACH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLS_FLIGHT_FLY_EACH_INL_H_
#undef WELLS_FLIGHT_FLY_EACH_INL_H_
#else
#define WELLS_FLIGHT_FLY_EACH_INL_H_
#endif

#include "flight/integrators.h"
#include "forces/wide_acceleration-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

/// Calls step(x, v), which changes them, for each ball's WideVectors of position and velocity.
template <class Step>
HWY_INLINE void flyEach(const FlightArrays& balls, const Step& step) {
  forEachVector(balls.count, [&](auto d, std::size_t i) HWY_ATTR {
    auto x = load(d, balls.x + i, balls.y + i, balls.z + i);
    auto v = load(d, balls.vx + i, balls.vy + i, balls.vz + i);
    step(x, v);
    store(x, balls.x + i, balls.y + i, balls.z + i);
    store(v, balls.vx + i, balls.vy + i, balls.vz + i);
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
