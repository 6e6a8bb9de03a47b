// What gases show when they are measured: pressure, free time, speeds and cooling. Used by the
// tests, and by the table of longer runs (tests/physics/gas_table.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "support/periodic_gas.h"
#include "support/sample.h"

namespace wells {

/// Goes on for 20 hits a ball: the gas forgets its lattice and its equal speeds.
void settle(PeriodicGas& gas);

/// Of an elastic gas; one value a seed.
struct FluidSamples {
  Sample pressure;  // P sigma^3 / kT
  Sample freeTime;  // between two hits of a ball, in sigma sqrt(m / kT)
};

/// `hits` impacts in all for each of the seeds 1 .. seeds.
FluidSamples measureFluid(double density, std::size_t balls, std::int64_t hits, int seeds);

/// T over what Haff's law says, after each of `hitsPerBall` (rising) from when restitution sets in;
/// one sample for each of them, one value a seed.
std::vector<Sample> measureCooling(double density, double elasticity, std::size_t balls, int seeds,
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
