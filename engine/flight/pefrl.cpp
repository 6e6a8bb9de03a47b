#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/pefrl.cpp"
#include <hwy/foreach_target.h>

#include "flight/fly_each-inl.h"
#include "flight/methods.h"
#include "math/elementary.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

// Omelyan, Mryglod & Folk, "Optimized Forest-Ruth- and Suzuki-like algorithms for integration of
// motion in many-body systems", Comput. Phys. Commun. 146 (2002) 188, eqs. (20), (22): position
// version, fourth order, symplectic.
constexpr double kXi = 0.1786178958448091;
constexpr double kLambda = -0.2123418310626054;
constexpr double kChi = -0.06626458266981849;

/// A kick of duration tau with drag: v' = a - k v at fixed position, solved exactly.
struct Kick {
  double keep = 1;  // e^(-k tau)
  double gain = 0;  // s, (1 - e^(-k tau)) / k

  Kick(double tau, double k) : gain(tau) {
    if (k == 0) return;
    keep = exponential(-k * tau);
    gain = (1 - keep) / k;
  }
};

void pefrl(const Flight& flight, const FlightArrays& balls) {
  const Field& field = *flight.field;
  const double h = flight.duration;
  const double k = dragRate(flight.drag);
  const Kick outer((1 - 2 * kLambda) * h / 2, k);
  const Kick inner(kLambda * h, k);
  const double edge = kXi * h;
  const double near = kChi * h;
  const double middle = (1 - 2 * (kChi + kXi)) * h;
  const double t = flight.start;
  flyEach(balls, [&](auto& x, auto& v) HWY_ATTR {
    x += v * edge;
    v = v * outer.keep + acceleration(field, x, t + edge) * outer.gain;
    x += v * near;
    v = v * inner.keep + acceleration(field, x, t + edge + near) * inner.gain;
    x += v * middle;
    v = v * inner.keep + acceleration(field, x, t + edge + near + middle) * inner.gain;
    x += v * near;
    v = v * outer.keep + acceleration(field, x, t + h - edge) * outer.gain;
    x += v * edge;
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(pefrl);

void flyPefrl(const Flight& flight, const FlightArrays& balls) {
  HWY_DYNAMIC_DISPATCH(pefrl)(flight, balls);
}

}  // namespace wells
#endif
