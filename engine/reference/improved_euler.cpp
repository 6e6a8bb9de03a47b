#include "reference/integrators.h"

namespace wells {

void advanceImprovedEuler(const ReferenceStep& step, ReferenceBall& ball) {
  const double h = step.h;
  const Vec3 force = ball.force + wellForce(step, ball, ball.position, 0);
  ball.position += (ball.velocity + ball.lastVelocity) * (h / 2) + step.gravity * (h * h / 2);
  ball.lastVelocity = ball.velocity;
  ball.velocity += (step.gravity + force * ball.inverseMass) * h;
  ball.velocity *= step.dampingOfStep;
  ball.force.setZero();
}

}  // namespace wells
