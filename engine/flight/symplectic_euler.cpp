#include "flight/methods.h"

namespace wells {

void flySymplecticEuler(const Flight& flight, std::span<const std::uint32_t> balls, Vec3* position,
                        Vec3* velocity) {
  const double h = flight.duration;
  const double slowdown = dragFactor(flight.drag, h);
  for (const std::uint32_t i : balls) {
    velocity[i] =
        (velocity[i] + acceleration(*flight.field, position[i], flight.start) * h) * slowdown;
    position[i] += velocity[i] * h;
  }
}

}  // namespace wells
