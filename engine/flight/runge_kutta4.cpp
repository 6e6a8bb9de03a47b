#include "flight/methods.h"

namespace wells {

// Drag enters as the force -k v per mass with k = -ln(drag), so that it is of fourth order too.
void flyRungeKutta4(const Flight& flight, std::span<const std::uint32_t> balls, Vec3* position,
                    Vec3* velocity) {
  const Field& field = *flight.field;
  const double h = flight.duration;
  const double half = h / 2;
  const double t = flight.start;
  const double k = dragRate(flight.drag);
  for (const std::uint32_t i : balls) {
    const Vec3 x = position[i];
    const Vec3 v1 = velocity[i];
    const Vec3 a1 = acceleration(field, x, t) - k * v1;
    const Vec3 v2 = v1 + half * a1;
    const Vec3 a2 = acceleration(field, x + half * v1, t + half) - k * v2;
    const Vec3 v3 = v1 + half * a2;
    const Vec3 a3 = acceleration(field, x + half * v2, t + half) - k * v3;
    const Vec3 v4 = v1 + h * a3;
    const Vec3 a4 = acceleration(field, x + h * v3, t + h) - k * v4;
    position[i] = x + (h / 6) * (v1 + 2 * (v2 + v3) + v4);
    velocity[i] = v1 + (h / 6) * (a1 + 2 * (a2 + a3) + a4);
  }
}

}  // namespace wells
