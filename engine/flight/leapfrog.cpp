#include "flight/methods.h"

namespace wells {

// Drag is exact in velocity and split around the kick (Strang), which keeps the second order.
void flyLeapfrog(const Flight& flight, std::span<const std::uint32_t> balls, Vec3* position,
                 Vec3* velocity) {
  const double h = flight.duration;
  const double half = h / 2;
  const double middle = flight.start + half;
  const double slowdown = dragFactor(flight.drag, half);
  for (const std::uint32_t i : balls) {
    position[i] += velocity[i] * half;
    velocity[i] =
        (velocity[i] * slowdown + acceleration(*flight.field, position[i], middle) * h) * slowdown;
    position[i] += velocity[i] * half;
  }
}

}  // namespace wells
