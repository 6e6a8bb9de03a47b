#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/leapfrog.cpp"
#include <hwy/foreach_target.h>

#include "flight/fly_each-inl.h"
#include "flight/methods.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

// Drag is exact in velocity and split around the kick (Strang), which keeps the second order.
void leapfrog(const Flight& flight, const FlightArrays& balls) {
  const double h = flight.duration;
  const double half = h / 2;
  const double middle = flight.start + half;
  const double slowdown = dragFactor(flight.drag, half);
  flyEach(balls, [&](auto& x, auto& v) HWY_ATTR {
    x += v * half;
    v = (v * slowdown + acceleration(*flight.field, x, middle) * h) * slowdown;
    x += v * half;
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(leapfrog);

void flyLeapfrog(const Flight& flight, const FlightArrays& balls) {
  HWY_DYNAMIC_DISPATCH(leapfrog)(flight, balls);
}

}  // namespace wells
#endif
