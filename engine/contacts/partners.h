// The partner of a ball in a contact: another ball, or the arena, which does not move. Both offer
// the same handful of operations, so that what impulses do is written once and compiled twice.
#pragma once

#include "contacts/contact.h"

namespace wells {

// Angular velocity times radius that a tangent impulse of 1 N s gives a ball of 1 kg: r^2 m / I.
inline constexpr double kSpinFactor = 1 / kInertiaFactor;

// isFurther() tells whether the gap is certainly larger than so many m; across() is the vector (m)
// in whose direction the normal lies, acrossRate() how it changes (m/s).
struct BallPartner {
  static void touch(const Arena&, const Balls& balls, Contact& c) { touchBalls(balls, c); }
  static bool isFurther(const Arena&, const Balls& balls, const Contact& c, double gap) {
    const double distance = balls.radius[c.a] + balls.radius[c.b] + gap;
    return squaredLength(balls.position[c.b] - balls.position[c.a]) > distance * distance;
  }
  static double inverseMass(const Balls& balls, const Contact& c) { return 1 / balls.mass[c.b]; }
  static double radius(const Balls& balls, const Contact& c) { return balls.radius[c.b]; }
  static Vec3 velocity(const Vec3* velocities, const Contact& c) { return velocities[c.b]; }
  static Vec3 surfaceSpin(const Balls& balls, const Contact& c) {
    return balls.radius[c.b] * balls.spin[c.b];
  }
  static Vec3 spin(const Balls& balls, const Contact& c) { return balls.spin[c.b]; }
  static double inverseInertia(const Balls& balls, const Contact& c) {
    return kSpinFactor * c.inverseMassB / (balls.radius[c.b] * balls.radius[c.b]);
  }
  static Vec3 across(const Arena&, const Vec3* positions, const Contact& c) {
    return positions[c.b] - positions[c.a];
  }
  static Vec3 acrossRate(const Vec3* velocities, const Contact& c) {
    return velocities[c.b] - velocities[c.a];
  }
  static void push(Balls& balls, const Contact& c, const Vec3& impulse) {
    balls.velocity[c.b] += c.inverseMassB * impulse;
  }
  static void twist(Balls& balls, const Contact& c, const Vec3& torquePerRadius) {
    balls.spin[c.b] += (kSpinFactor * c.inverseMassB / balls.radius[c.b]) * torquePerRadius;
  }
  static void turn(Balls& balls, const Contact& c, const Vec3& torque) {
    balls.spin[c.b] += inverseInertia(balls, c) * torque;
  }
  static void shift(Balls& balls, const Contact& c, const Vec3& massTimesDistance) {
    balls.position[c.b] += c.inverseMassB * massTimesDistance;
  }
};

struct ArenaPartner {
  static void touch(const Arena& arena, const Balls& balls, Contact& c) {
    touchArena(arena, balls, c);
  }
  static bool isFurther(const Arena& arena, const Balls& balls, const Contact& c, double gap) {
    const Vec3 d = balls.position[c.a] - arena.center;
    const double reach = balls.radius[c.a] + gap;  // of the centre
    if (c.b == kGround) return d.y() > reach;
    const double within = arena.radius - reach;
    return within > 0 && d.x() * d.x() + d.z() * d.z() < within * within;
  }
  static double inverseMass(const Balls&, const Contact&) { return 0; }
  static double radius(const Balls& balls, const Contact& c) { return balls.radius[c.a]; }
  static Vec3 velocity(const Vec3*, const Contact&) { return Vec3::Zero(); }
  static Vec3 surfaceSpin(const Balls&, const Contact&) { return Vec3::Zero(); }
  static Vec3 spin(const Balls&, const Contact&) { return Vec3::Zero(); }
  static double inverseInertia(const Balls&, const Contact&) { return 0; }
  static Vec3 across(const Arena& arena, const Vec3* positions, const Contact& c) {
    const Vec3 d = positions[c.a] - arena.center;
    return c.b == kGround ? Vec3(0, -1, 0) : Vec3(d.x(), 0, d.z());
  }
  static Vec3 acrossRate(const Vec3* velocities, const Contact& c) {
    const Vec3& v = velocities[c.a];
    return c.b == kGround ? Vec3(0, 0, 0) : Vec3(v.x(), 0, v.z());
  }
  static void push(Balls&, const Contact&, const Vec3&) {}
  static void twist(Balls&, const Contact&, const Vec3&) {}
  static void turn(Balls&, const Contact&, const Vec3&) {}
  static void shift(Balls&, const Contact&, const Vec3&) {}
};

/// Calls action.template operator()<Partner>() with the partner of that contact.
template <class Action>
void withPartner(const Contact& c, Action action) {
  if (isBall(c.b))
    action.template operator()<BallPartner>();
  else
    action.template operator()<ArenaPartner>();
}

/// kg; what an impulse along the normal has to move.
inline double normalMass(const Contact& c) {
  return 1 / (c.inverseMassA + c.inverseMassB);
}

/// kg; 1/m + r^2/I for each of the two spheres: inertia is a number, so the tangent plane has one
/// mass.
inline double tangentMass(const Contact& c) {
  return normalMass(c) / (1 + kSpinFactor);
}

template <class Partner>
double closingSpeed(const Vec3* velocities, const Contact& c) {
  return dot(velocities[c.a] - Partner::velocity(velocities, c), c.normal);
}

/// Relative velocity (m/s, a against b) of the two surfaces at the contact point, in the tangent
/// plane.
template <class Partner>
Vec3 slipVelocity(const Balls& balls, const Contact& c) {
  const Vec3 slip =
      balls.velocity[c.a] - Partner::velocity(balls.velocity.data(), c) +
      cross(balls.radius[c.a] * balls.spin[c.a] + Partner::surfaceSpin(balls, c), c.normal);
  return slip - dot(slip, c.normal) * c.normal;
}

/// Gives a the impulse (N s), and b the opposite.
template <class Partner>
void applyImpulse(Balls& balls, const Contact& c, const Vec3& impulse) {
  balls.velocity[c.a] += c.inverseMassA * impulse;
  Partner::push(balls, c, -impulse);
}

/// An impulse in the tangent plane. It acts at r_a n from a and at -r_b n from b, so both spins
/// change in the same sense.
template <class Partner>
void applyTangentImpulse(Balls& balls, const Contact& c, const Vec3& impulse) {
  applyImpulse<Partner>(balls, c, impulse);
  const Vec3 torquePerRadius = cross(c.normal, impulse);
  balls.spin[c.a] += (kSpinFactor * c.inverseMassA / balls.radius[c.a]) * torquePerRadius;
  Partner::twist(balls, c, torquePerRadius);
}

/// 1/(kg m^2); what a torque between the two has to turn.
template <class Partner>
double inverseTurningInertia(const Balls& balls, const Contact& c) {
  const double a = kSpinFactor * c.inverseMassA / (balls.radius[c.a] * balls.radius[c.a]);
  return a + Partner::inverseInertia(balls, c);
}

/// The rolling part of the relative angular velocity (rad/s, a against b): that in the tangent
/// plane. It does not depend on the radii, nor on how the observer turns.
template <class Partner>
Vec3 rollingVelocity(const Balls& balls, const Contact& c) {
  const Vec3 turning = balls.spin[c.a] - Partner::spin(balls, c);
  return turning - dot(turning, c.normal) * c.normal;
}

/// Gives a the impulse of a torque (N m s), and b the opposite.
template <class Partner>
void applyTorqueImpulse(Balls& balls, const Contact& c, const Vec3& torque) {
  balls.spin[c.a] +=
      (kSpinFactor * c.inverseMassA / (balls.radius[c.a] * balls.radius[c.a])) * torque;
  Partner::turn(balls, c, -torque);
}

}  // namespace wells
