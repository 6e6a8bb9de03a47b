#include "forces/field.h"

#include "math/elementary.h"

namespace wells {

Field fieldOf(const World& world) {
  return fieldAt(world, world.step);
}

Field fieldAt(const World& world, std::int64_t step) {
  return {world.settings.gravity, activeWells(world, step)};
}

double dragFactor(double drag, double h) {
  return drag == 1 ? 1 : exponential(h * naturalLogarithm(drag));
}

}  // namespace wells
