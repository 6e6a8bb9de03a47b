// The stress cases: worlds that break engines, how to step them, and which promises must hold. Data
// only; tests and `bench stress` run and judge them.
//
// In all cases: after the last step of `apart` nobody is outside the arena; no ball becomes not
// finite but those that start so; no step is endless. Where a ball starts not finite, the others
// end with the same bits as in the world without it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "scenes/stress.h"

namespace wells {

/// What kinetic + potential energy may do from one step to any later one.
enum class EnergyPromise : std::uint8_t {
  NeverRises,  // contacts, friction and gravity alone: never, but for rounding
  Pressed,     // gravity or wells press balls together for long: but for what pushing out lifts
               // them by, and for the integrator's residual near wells
  WellsMove    // wells do work: no promise on the sum
};

struct StressCase {
  std::string_view name;
  std::string_view about;  // one line
  int versions;            // worlds, one after the other
  StressWorld (*make)(int version);
  std::int64_t steps;      // of each world
  double secondDt = 0;     // s; not 0: of every second step
  std::int64_t apart = 0;  // steps until the overlaps of the start must be gone
  EnergyPromise energy = EnergyPromise::NeverRises;
};

std::span<const StressCase> stressCases();

/// The case of that name, or throws std::invalid_argument with the names that exist.
const StressCase& findStressCase(std::string_view name);

/// Sets the time step that comes next (steps count from 0): settings.dt of the start, or secondDt.
void setDt(const StressCase& stress, const World& start, World& world);

}  // namespace wells
