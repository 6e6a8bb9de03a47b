#include "flight/methods.h"

namespace wells {

// The explicit trapezoidal rule. Drag enters as the force -k v per mass.
void flyHeun(const Flight& flight, std::span<const std::uint32_t> balls, Vec3* position,
             Vec3* velocity) {
  const double h = flight.duration;
  const double k = dragRate(flight.drag);
  for (const std::uint32_t i : balls) {
    const Vec3 x = position[i];
    const Vec3 v = velocity[i];
    const Vec3 a = acceleration(*flight.field, x, flight.start) - k * v;
    const Vec3 end = v + h * a;
    const Vec3 aEnd = acceleration(*flight.field, x + h * v, flight.start + h) - k * end;
    position[i] = x + (h / 2) * (v + end);
    velocity[i] = v + (h / 2) * (a + aEnd);
  }
}

}  // namespace wells
