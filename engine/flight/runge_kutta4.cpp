#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/runge_kutta4.cpp"
#include <hwy/foreach_target.h>

#include "flight/fly_each-inl.h"
#include "flight/methods.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

// Drag enters as the force -k v per mass with k = -ln(drag), so that it is of fourth order too.
void rungeKutta4(const Flight& flight, const FlightArrays& balls) {
  const Field& field = *flight.field;
  const double h = flight.duration;
  const double half = h / 2;
  const double t = flight.start;
  const double k = dragRate(flight.drag);
  flyEach(balls, [&](auto& x, auto& v) HWY_ATTR {
    const auto a1 = acceleration(field, x, t) - k * v;
    const auto v2 = v + half * a1;
    const auto a2 = acceleration(field, x + half * v, t + half) - k * v2;
    const auto v3 = v + half * a2;
    const auto a3 = acceleration(field, x + half * v2, t + half) - k * v3;
    const auto v4 = v + h * a3;
    const auto a4 = acceleration(field, x + h * v3, t + h) - k * v4;
    x += (h / 6) * (v + 2 * (v2 + v3) + v4);
    v += (h / 6) * (a1 + 2 * (a2 + a3) + a4);
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(rungeKutta4);

void flyRungeKutta4(const Flight& flight, const FlightArrays& balls) {
  HWY_DYNAMIC_DISPATCH(rungeKutta4)(flight, balls);
}

}  // namespace wells
#endif
