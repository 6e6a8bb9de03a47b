#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/symplectic_euler.cpp"
#include <hwy/foreach_target.h>

#include "flight/fly_each-inl.h"
#include "flight/methods.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

void symplecticEuler(const Flight& flight, const FlightArrays& balls) {
  const double h = flight.duration;
  const double slowdown = dragFactor(flight.drag, h);
  flyEach(balls, [&](auto& x, auto& v) HWY_ATTR {
    v = (v + acceleration(*flight.field, x, flight.start) * h) * slowdown;
    x += v * h;
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(symplecticEuler);

void flySymplecticEuler(const Flight& flight, const FlightArrays& balls) {
  HWY_DYNAMIC_DISPATCH(symplecticEuler)(flight, balls);
}

}  // namespace wells
#endif
