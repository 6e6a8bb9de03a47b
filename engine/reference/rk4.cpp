#include "reference/integrators.h"

namespace wells {

void advanceRk4(const ReferenceStep& step, ReferenceBall& ball) {
  const double h = step.h;
  // The rolling force is held over the step: it is known only where detection found it.
  const Vec3 constant = step.gravity + ball.force * ball.inverseMass;
  const auto slope = [&](const Vec3& position, double t) -> Vec3 {
    return constant + acceleration(step.wells, position, t);
  };
  const Vec3 p = ball.position;
  const Vec3 v1 = ball.velocity;
  const Vec3 a1 = slope(p, 0);
  const Vec3 v2 = v1 + a1 * (h / 2);
  const Vec3 a2 = slope(p + v1 * (h / 2), h / 2);
  const Vec3 v3 = v1 + a2 * (h / 2);
  const Vec3 a3 = slope(p + v2 * (h / 2), h / 2);
  const Vec3 v4 = v1 + a3 * h;
  const Vec3 a4 = slope(p + v3 * h, h);
  ball.position += (v1 + (v2 + v3) * 2 + v4) * (h / 6);
  ball.velocity += (a1 + (a2 + a3) * 2 + a4) * (h / 6);
  ball.velocity *= step.dampingOfStep;
  ball.force.setZero();
}

}  // namespace wells
