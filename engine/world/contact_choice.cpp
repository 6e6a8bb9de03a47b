#include "world/contact_choice.h"

#include <algorithm>

namespace wells {

bool isLossless(const Settings& settings) {
  return settings.elasticity == 1 && settings.friction == 0;
}

bool isCrowd(const Settings& settings, std::span<const std::uint32_t> island, const Balls& balls,
             std::span<const std::uint8_t> stepsInSubsteps) {
  if (isLossless(settings)) return false;
  if (island.size() <= kCrowd / 2) return false;
  const double substep = settings.dt / settings.substeps;
  const bool anyFast = std::any_of(island.begin(), island.end(), [&](std::uint32_t i) {
    return length(balls.velocity[i]) * substep > balls.radius[i];
  });
  if (anyFast) return false;
  return std::any_of(island.begin(), island.end(),
                     [&](std::uint32_t i) { return stepsInSubsteps[i] > 0; });
}

}  // namespace wells
