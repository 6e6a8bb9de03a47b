#include "forces/field.h"

#include "math/elementary.h"

namespace wells {

Field fieldOf(const World& world) {
  Field field;
  updateField(world, world.step, field);
  return field;
}

void updateField(const World& world, std::int64_t step, Field& field) {
  field.gravity = world.settings.gravity;
  field.wells.clear();
  for (const WellTrack& track : world.tracks) {
    const Well well = wellAt(track, step, world.settings.dt);
    if (well.strength != 0) field.wells.push_back(well);
  }
}

double dragFactor(double drag, double h) {
  return drag == 1 ? 1 : exponential(h * naturalLogarithm(drag));
}

}  // namespace wells
