#include "support/gas_measures.h"

#include <cmath>
#include <numbers>

#include "scenes/flat_gas.h"
#include "support/gas_theory.h"
#include "support/wall_impulses.h"
#include "world/simulation.h"

namespace wells {

void settle(PeriodicGas& gas, int hitsPerBall) {
  const auto balls = static_cast<std::int64_t>(gas.balls().size());
  gas.runToHits(gas.hits() + hitsPerBall * balls / 2);
}

// The virial theorem: P V = N kT + 1/3 (sum of x_ab . impulse per time). That N is finite changes
// pressure and hit rate by some 1/N.
FluidSamples measureFluid(const FluidRun& run) {
  FluidSamples samples;
  const auto n = static_cast<double>(run.balls);
  for (int seed = 1; seed <= run.seeds; ++seed) {
    PeriodicGas gas(run.balls, run.density, seed);
    settle(gas, run.settling);
    const double start = gas.time(), virial = gas.virial();
    gas.runToHits(gas.hits() + run.hits);
    const double duration = gas.time() - start;
    samples.pressure.values.push_back(
        run.density * (1 + (gas.virial() - virial) / (3 * n * gas.temperature() * duration)));
    samples.freeTime.values.push_back(n * duration / (2 * static_cast<double>(run.hits)));
  }
  return samples;
}

std::vector<Sample> measureCooling(double density, double elasticity, std::int64_t balls, int seeds,
                                   std::span<const int> hitsPerBall) {
  std::vector<Sample> samples(hitsPerBall.size());
  for (int seed = 1; seed <= seeds; ++seed) {
    PeriodicGas gas(balls, density, seed);
    settle(gas);
    gas.setElasticity(elasticity);
    const double start = gas.time();
    const std::int64_t before = gas.hits();
    for (std::size_t k = 0; k < hitsPerBall.size(); ++k) {
      gas.runToHits(before + hitsPerBall[k] * balls / 2);
      samples[k].values.push_back(gas.temperature() /
                                  theory::haffCooling(density, elasticity, gas.time() - start));
    }
  }
  return samples;
}

namespace {

/// Sum of m x . v (J s).
double momentOfMomentum(const Balls& balls) {
  double sum = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    sum += balls.mass[i] * dot(balls.position[i], balls.velocity[i]);
  return sum;
}

}  // namespace

// The centres' room is the disc of R - r: its area is the gas's, its rim is what the wall's
// impulses press on. With both, P A = N kT holds exactly for points. The virial theorem,
//   2 K t + sum of sigma J over pairs = (R - r) sum of J at the wall + change of sum m x . v,
// says that what the wall got is as steady as what pairs exchange but for the last term, the gas
// sloshing about: it goes as 1/t, and is 0.5 % after 33 s.
FlatGas measureFlatGas(std::uint64_t seed, int settlingSteps, int steps) {
  World world = makeFlatGas(4000, seed);
  const auto n = static_cast<double>(world.balls.size());
  const double room = world.arena.radius - 0.5;
  const auto simulation = makeSimulation();
  for (int i = 0; i < settlingSteps; ++i) simulation->step(world);
  const double moment = momentOfMomentum(world.balls);
  FlatGas gas;
  for (int i = 0; i < steps; ++i) {
    const Balls before = world.balls;
    simulation->step(world);
    gas.wallImpulse += wallImpulses(before, world.balls, world.settings.dt);
  }
  double twiceEnergy = 0;
  for (const Vec3& v : world.balls.velocity) twiceEnergy += squaredLength(v);
  const double temperature = twiceEnergy / 2 / n;
  for (const Vec3& v : world.balls.velocity)
    gas.speeds.values.push_back(length(v) / std::sqrt(temperature));
  // P A / (N kT) with P = J / (2 pi room t), A = pi room^2.
  const double perImpulse = room / (2 * n * temperature * steps * world.settings.dt);
  gas.compressibility = perImpulse * gas.wallImpulse;
  gas.steady = gas.compressibility + perImpulse * (momentOfMomentum(world.balls) - moment) / room;
  return gas;
}

}  // namespace wells
