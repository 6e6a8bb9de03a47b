#include "forces/field.h"

#include "math/elementary.h"

namespace wells {

Field fieldOf(const World& world) {
  return {world.settings.gravity, activeWells(world)};
}

double dragFactor(double drag, double h) {
  return drag == 1 ? 1 : exponential(h * naturalLogarithm(drag));
}

}  // namespace wells
