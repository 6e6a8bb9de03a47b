// Looks for a violation of a promise that a planted defect leads to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace wells::planted {

struct Catch {
  std::string promise;  // that was broken ...
  std::string what;     // ... and how
};

/// The number of no defect.
inline constexpr int kNone = 0;

/// One simulated session of this seed with a defect.
std::optional<Catch> simulate(int defect, std::uint64_t seed);

struct Searched {
  std::uint64_t states = 0;
  std::optional<Catch> caught;
};

/// Searches all interleavings with a defect in ownership/, within limits that take a second.
Searched search(int defect);

}  // namespace wells::planted
