#include "reference/integrators.h"

namespace wells {
namespace {

struct Slope {
  Vec3 velocity = Vec3::Zero();
  Vec3 acceleration = Vec3::Zero();
};

/// The report's stage: it should look at a copy that is tau ahead, and moves the ball instead.
Slope stage(ReferenceBall& ball, const Vec3& force, double tau, const Slope& k) {
  ball.position += k.velocity * tau;
  ball.velocity += k.acceleration * tau;
  return {ball.velocity, force * ball.inverseMass};
}

}  // namespace

void advanceRungeKutta(const ReferenceStep& step, ReferenceBall& ball) {
  const double h = step.h;
  const Vec3 force =
      ball.force + step.gravity * ball.mass + wellForce(step, ball, ball.position, 0);
  const Slope k1 = stage(ball, force, 0, {});
  const Slope k2 = stage(ball, force, h / 2, k1);
  const Slope k3 = stage(ball, force, h / 2, k2);
  const Slope k4 = stage(ball, force, h, k3);
  ball.position += (k1.velocity + (k2.velocity + k3.velocity) * 2 + k4.velocity) * (h / 6);
  ball.velocity +=
      (k1.acceleration + (k2.acceleration + k3.acceleration) * 2 + k4.acceleration) * (h / 6);
  ball.velocity *= step.damping;
  ball.force.setZero();
}

}  // namespace wells
