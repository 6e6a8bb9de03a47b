// Looks for a violation of a promise that a planted defect leads to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "planted/defects.h"

namespace wells::planted {

struct Catch {
  std::string promise;  // that was broken ...
  std::string what;     // ... and how
};

enum class Planting : std::uint8_t { On, Off };

/// One simulated session of this seed, with the faults of the defect; Off: as if it were not there.
std::optional<Catch> simulate(const Defect& defect, std::uint64_t seed, Planting planting);

struct Searched {
  std::uint64_t states = 0;  // looked at
  std::optional<Catch> caught;
};

/// Searches all interleavings with a defect in ownership/, within limits that take a second.
Searched search(const Defect& defect);

}  // namespace wells::planted
