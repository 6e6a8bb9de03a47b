// What gases show when they are measured: pressure, free time, speeds and cooling. Used by the
// tests, and by the table of longer runs (tests/physics/gas_table.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "support/periodic_gas.h"
#include "support/sample.h"

namespace wells {

/// Goes on for so many hits a ball. 20 make it forget its equal speeds, and a lattice that is not
/// dense; at eta = 0.45 it stays a crystal for 30, in which the pressure is 10 % lower.
void settle(PeriodicGas& gas, int hitsPerBall = 20);

/// Of an elastic gas; one value a seed.
struct FluidSamples {
  Sample pressure;  // P sigma^3 / kT
  Sample freeTime;  // between two hits of a ball, in sigma sqrt(m / kT)
};

struct FluidRun {
  double density = 0;  // balls in a cubic diameter
  std::int64_t balls = 2048;
  int settling = 20;      // hits a ball, before
  std::int64_t hits = 0;  // in all
  int seeds = 1;          // 1 .. seeds, one after the other
};

FluidSamples measureFluid(const FluidRun& run);

/// T over what Haff's law says, after each of `hitsPerBall` (rising) from when restitution sets in;
/// one sample for each of them, one value a seed.
std::vector<Sample> measureCooling(double density, double elasticity, std::int64_t balls, int seeds,
                                   std::span<const int> hitsPerBall);

/// Of the flat gas in the arena, through the whole engine.
struct FlatGas {
  double compressibility = 0;  // P A / (N kT)
  double steady = 0;           // the same, freed of what the gas sloshes: see the .cpp
  double wallImpulse = 0;      // N s, sum of the sizes
  Sample speeds;               // sqrt(kT/m), at the end
};

FlatGas measureFlatGas(std::uint64_t seed, int settlingSteps, int steps);

}  // namespace wells
