#include "flight/integrators.h"

#include "flight/methods.h"
#include "math/find_by_name.h"

namespace wells {
namespace {

constexpr Integrator kIntegrators[] = {
    {"symplectic-euler", "kick, then drift; what most engines do", 1, 1, false, flySymplecticEuler},
    {"leapfrog", "drift, kick, drift; exact for constant gravity", 2, 1, true, flyLeapfrog},
    {"heun", "explicit trapezoidal rule", 2, 2, true, flyHeun},
    {"rk4", "textbook Runge-Kutta, the force evaluated anew at each stage", 4, 4, true,
     flyRungeKutta4},
    {"pefrl", "symplectic of fourth order, as costly as rk4 and far more exact", 4, 4, true,
     flyPefrl},
};

}  // namespace

std::span<const Integrator> integrators() {
  return kIntegrators;
}

const Integrator& findIntegrator(std::string_view name) {
  return findByName(kIntegrators, &Integrator::name, "integrator", name);
}

}  // namespace wells
