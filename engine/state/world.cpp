#include "state/world.h"

namespace wells {

std::vector<Well> activeWells(const World& world, std::int64_t step) {
  std::vector<Well> wells;
  wells.reserve(world.tracks.size());
  for (const WellTrack& track : world.tracks) {
    const Well well = wellAt(track, step, world.settings.dt);
    if (well.strength != 0) wells.push_back(well);
  }
  return wells;
}

}  // namespace wells
