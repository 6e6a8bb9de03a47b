#include "forces/field.h"

#include <algorithm>
#include <cmath>

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
  const double dt = world.settings.dt;
  field.stretches = stretchesOf(field.wells, dt);
  field.stretch = dt / static_cast<double>(field.stretches);
}

double stretchesWanted(double strength, double softening, double dt) {
  const double omega = std::sqrt(std::abs(strength) / (softening * softening * softening));
  return dt * omega / kStretchPhase;
}

std::int64_t stretchesOf(const FieldWells& wells, double dt) {
  double most = 1;
  for (const Well& well : wells)
    most = std::max(most, stretchesWanted(well.strength, well.softening, dt));
  return static_cast<std::int64_t>(std::min(std::ceil(most), static_cast<double>(kMostStretches)));
}

double dragRate(double drag) {
  return drag == 1 ? 0 : -naturalLogarithm(drag);
}

double dragFactor(double drag, double h) {
  return drag == 1 ? 1 : exponential(-h * dragRate(drag));
}

}  // namespace wells
