// One ball as the custom integrator sees it, and what a step gives to every ball.
#pragma once

#include "forces/field.h"
#include "math/vector.h"

namespace wells {

struct ReferenceBall {
  Vec3 position = Vec3::Zero();      // m, p
  Vec3 velocity = Vec3::Zero();      // m/s, v
  Vec3 lastVelocity = Vec3::Zero();  // m/s, v_last: v at the start of the previous step
  Vec3 force = Vec3::Zero();         // N, F: on entry what the last detection left (rolling)
  double mass = 1;                   // kg, > 0
  double inverseMass = 1;            // 1/kg, w = 1 / mass
};

struct ReferenceStep {
  Vec3 gravity = Vec3::Zero();  // m/s^2, the constant acceleration a
  Field wells;                  // the wells alone, its gravity is zero
  double h = 1.0 / 60;          // s
  double damping = 1;           // d, in (0, 1]
  double dampingOfStep = 1;     // d^h
};

/// The force (N) of the wells on the ball if it were at `position`, t seconds into the step.
inline Vec3 wellForce(const ReferenceStep& step, const ReferenceBall& ball, const Vec3& position,
                      double t) {
  return acceleration(step.wells, position, t) * ball.mass;
}

}  // namespace wells
