#include "flight/integrators.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <vector>

#include "flight/methods.h"

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
  for (const Integrator& integrator : kIntegrators)
    if (integrator.name == name) return integrator;
  std::vector<std::string_view> names;
  for (const Integrator& integrator : kIntegrators) names.push_back(integrator.name);
  throw std::invalid_argument(
      fmt::format("integrator '{}' is unknown; allowed: {}", name, fmt::join(names, ", ")));
}

}  // namespace wells
