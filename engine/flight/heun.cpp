#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/heun.cpp"
#include <hwy/foreach_target.h>

#include "flight/fly_each-inl.h"
#include "flight/methods.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

// The explicit trapezoidal rule. Drag enters as the force -k v per mass.
void heun(const Flight& flight, const FlightArrays& balls) {
  const double h = flight.duration;
  const double k = dragRate(flight.drag);
  flyEach(balls, [&](auto& x, auto& v) HWY_ATTR {
    const auto a = acceleration(*flight.field, x, flight.start) - k * v;
    const auto end = v + h * a;
    const auto aEnd = acceleration(*flight.field, x + h * v, flight.start + h) - k * end;
    x += (h / 2) * (v + end);
    v += (h / 2) * (a + aEnd);
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(heun);

void flyHeun(const Flight& flight, const FlightArrays& balls) {
  HWY_DYNAMIC_DISPATCH(heun)(flight, balls);
}

}  // namespace wells
#endif
