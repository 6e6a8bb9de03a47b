// Looks for a violation of a promise that a planted defect leads to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace wells::planted {

struct Catch {
  std::string promise;      // that was broken
  std::uint64_t count = 0;  // the seed, or the states until then
};

/// One simulated session of this seed with defect `number`; 0: without.
std::optional<Catch> simulateSeed(int number, std::uint64_t seed);

/// Searches all interleavings within limits that a few seconds are enough for.
std::optional<Catch> search(int number);

}  // namespace wells::planted
