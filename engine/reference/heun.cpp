#include "reference/integrators.h"

namespace wells {

void advanceHeun(const ReferenceStep& step, ReferenceBall& ball) {
  const double h = step.h;
  // The rolling force is held over the step: it is known only where detection found it.
  const Vec3 constant = step.gravity + ball.force * ball.inverseMass;
  const Vec3 v0 = ball.velocity;
  const Vec3 a0 = constant + acceleration(step.wells, ball.position, 0);
  const Vec3 v1 = v0 + a0 * h;
  const Vec3 a1 = constant + acceleration(step.wells, ball.position + v0 * h, h);
  ball.position += (v0 + v1) * (h / 2);
  ball.velocity += (a0 + a1) * (h / 2);
  ball.velocity *= step.dampingOfStep;
  ball.force.setZero();
}

}  // namespace wells
