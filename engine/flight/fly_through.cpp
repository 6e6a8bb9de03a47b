#include <algorithm>

#include "flight/integrators.h"

namespace wells {
namespace {

void flyUnderGravity(const Vec3& gravity, double h, std::span<const std::uint32_t> balls,
                     Vec3* position, Vec3* velocity) {
  const Vec3 gain = gravity * h;
  for (const std::uint32_t i : balls) {
    position[i] += (velocity[i] + 0.5 * gain) * h;
    velocity[i] += gain;
  }
}

}  // namespace

void flyThrough(const Integrator& integrator, const Flight& flight,
                std::span<const std::uint32_t> balls, Vec3* position, Vec3* velocity) {
  const Field& field = *flight.field;
  if (field.wells.empty() && flight.drag == 1) {
    flyUnderGravity(field.gravity, flight.duration, balls, position, velocity);
    return;
  }
  Flight part = flight;
  double left = flight.duration;
  while (left > field.stretch * (1 + kNoRemainder)) {
    part.duration = field.stretch;
    integrator.fly(part, balls, position, velocity);
    part.start += field.stretch;
    left -= field.stretch;
  }
  part.duration = left;
  integrator.fly(part, balls, position, velocity);
}

}  // namespace wells
