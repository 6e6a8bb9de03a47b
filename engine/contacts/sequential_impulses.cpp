#include "contacts/sequential_impulses.h"

#include <algorithm>

namespace wells {
namespace {

// Share of a remaining overlap between balls that one substep pushes out. All of it at once makes a
// heap hop: each push-out creates the neighbour's overlap. The arena does not give way: all.
constexpr double kPushOutBalls = 0.6;
constexpr double kPushOutArena = 1.0;

// Angular velocity times radius that a tangent impulse of 1 N s gives a ball of 1 kg: r^2 m / I.
constexpr double kSpinFactor = 1 / kInertiaFactor;

// The partner of a ball: another ball, or the arena, which does not move. Both offer the same
// handful of operations, so that the solver is written once and compiled twice.
struct BallPartner {
  static constexpr double kPushOut = kPushOutBalls;
  static void touch(const Arena&, const Balls& balls, Contact& c) { touchBalls(balls, c); }
  static double inverseMass(const Balls& balls, const Contact& c) { return 1 / balls.mass[c.b]; }
  static Vec3 velocity(const Vec3* velocities, const Contact& c) { return velocities[c.b]; }
  static Vec3 surfaceSpin(const Balls& balls, const Contact& c) {
    return balls.radius[c.b] * balls.spin[c.b];
  }
  static void push(Balls& balls, const Contact& c, const Vec3& impulse) {
    balls.velocity[c.b] += c.inverseMassB * impulse;
  }
  static void twist(Balls& balls, const Contact& c, const Vec3& torquePerRadius) {
    balls.spin[c.b] += (kSpinFactor * c.inverseMassB / balls.radius[c.b]) * torquePerRadius;
  }
  static void shift(Balls& balls, const Contact& c, const Vec3& massTimesDistance) {
    balls.position[c.b] += c.inverseMassB * massTimesDistance;
  }
};

struct ArenaPartner {
  static constexpr double kPushOut = kPushOutArena;
  static void touch(const Arena& arena, const Balls& balls, Contact& c) {
    touchArena(arena, balls, c);
  }
  static double inverseMass(const Balls&, const Contact&) { return 0; }
  static Vec3 velocity(const Vec3*, const Contact&) { return Vec3::Zero(); }
  static Vec3 surfaceSpin(const Balls&, const Contact&) { return Vec3::Zero(); }
  static void push(Balls&, const Contact&, const Vec3&) {}
  static void twist(Balls&, const Contact&, const Vec3&) {}
  static void shift(Balls&, const Contact&, const Vec3&) {}
};

double normalMass(const Contact& c) {
  return 1 / (c.inverseMassA + c.inverseMassB);
}

// 1/m + r^2/I for each of the two spheres: inertia is a number, so the tangent plane has one mass.
double tangentMass(const Contact& c) {
  return normalMass(c) / (1 + kSpinFactor);
}

// Impulse on a; the partner gets the opposite.
template <class Partner>
void applyImpulse(Balls& balls, const Contact& c, const Vec3& impulse) {
  balls.velocity[c.a] += c.inverseMassA * impulse;
  Partner::push(balls, c, -impulse);
}

// Impulse in the tangent plane. It acts at r_a n from a and at -r_b n from b, so both spins change
// in the same sense.
template <class Partner>
void applyTangentImpulse(Balls& balls, const Contact& c, const Vec3& impulse) {
  applyImpulse<Partner>(balls, c, impulse);
  const Vec3 torquePerRadius = cross(c.normal, impulse);
  balls.spin[c.a] += (kSpinFactor * c.inverseMassA / balls.radius[c.a]) * torquePerRadius;
  Partner::twist(balls, c, torquePerRadius);
}

template <class Partner>
double closingSpeed(const Vec3* velocities, const Contact& c) {
  return dot(velocities[c.a] - Partner::velocity(velocities, c), c.normal);
}

// Geometry, masses and the bounce, from the state before any impulse of this substep.
template <class Partner>
void prepare(const Settings& settings, const Arena& arena, const Vec3* velocityBefore,
             const Balls& balls, Contact& c) {
  Partner::touch(arena, balls, c);
  const bool wasImpact = c.impact;
  if (c.gap <= 0) {
    const double closing = closingSpeed<Partner>(balls.velocity.data(), c);
    const double builtUp = std::max(0.0, closing - closingSpeed<Partner>(velocityBefore, c));
    c.impact = closing > kRestFactor * builtUp;
    c.bounceSpeed = c.impact ? settings.elasticity * closing : 0;
    c.inverseMassA = 1 / balls.mass[c.a];
    c.inverseMassB = Partner::inverseMass(balls, c);
  }
  // The impulse of an impact says nothing about the next substep's.
  if (c.gap > 0 || c.impact || wasImpact) {
    c.normalImpulse = 0;
    c.tangentImpulse.setZero();
  }
}

template <class Partner>
void warmStart(Balls& balls, Contact& c) {
  if (c.normalImpulse == 0) return;
  c.tangentImpulse -= dot(c.tangentImpulse, c.normal) * c.normal;  // the normal has turned
  applyImpulse<Partner>(balls, c, -c.normalImpulse * c.normal);
  applyTangentImpulse<Partner>(balls, c, c.tangentImpulse);
}

template <class Partner>
void solveNormal(Balls& balls, Contact& c) {
  const double closing = closingSpeed<Partner>(balls.velocity.data(), c);
  const double total = std::max(0.0, c.normalImpulse + normalMass(c) * (closing + c.bounceSpeed));
  const double change = total - c.normalImpulse;
  c.normalImpulse = total;
  applyImpulse<Partner>(balls, c, -change * c.normal);
}

template <class Partner>
void solveTangent(double friction, Balls& balls, Contact& c) {
  // Relative velocity of the two surfaces at the contact point.
  Vec3 slip = balls.velocity[c.a] - Partner::velocity(balls.velocity.data(), c) +
              cross(balls.radius[c.a] * balls.spin[c.a] + Partner::surfaceSpin(balls, c), c.normal);
  slip -= dot(slip, c.normal) * c.normal;
  Vec3 total = c.tangentImpulse - tangentMass(c) * slip;
  const double limit = friction * c.normalImpulse;
  const double size = length(total);
  if (size > limit) total *= limit / size;
  const Vec3 change = total - c.tangentImpulse;
  c.tangentImpulse = total;
  applyTangentImpulse<Partner>(balls, c, change);
}

// A contact that rests carried its impulse evenly over the substep: a constant force moves a ball
// by half of what the full change of velocity would. With it, a resting ball stays where it is and
// a sliding one brakes exactly. An impact is an instant, and gets none.
template <class Partner>
void shiftByContactForce(double h, Balls& balls, const Contact& c) {
  if (c.impact || c.normalImpulse == 0) return;
  const Vec3 shift = (c.tangentImpulse - c.normalImpulse * c.normal) * (h / 2);
  balls.position[c.a] += c.inverseMassA * shift;
  Partner::shift(balls, c, -shift);
}

// Overlap that the balls do not leave by themselves in the next substep.
template <class Partner>
void pushOut(const Arena& arena, double h, Balls& balls, Contact& c) {
  if (c.gap > 0) return;
  Partner::touch(arena, balls, c);
  const double leaving = std::max(0.0, -closingSpeed<Partner>(balls.velocity.data(), c)) * h;
  const double depth = -c.gap - leaving;
  if (depth <= 0) return;
  const Vec3 shift = (Partner::kPushOut * depth * normalMass(c)) * c.normal;
  balls.position[c.a] -= c.inverseMassA * shift;
  Partner::shift(balls, c, shift);
}

/// Calls action.template operator()<Partner>(contact) for all contacts, the arena's last.
template <class Action>
void forEach(const ContactLists& contacts, Action action) {
  for (Contact& c : contacts.balls) action.template operator()<BallPartner>(c);
  for (Contact& c : contacts.arena) action.template operator()<ArenaPartner>(c);
}

}  // namespace

void resolveContacts(const Settings& settings, const Arena& arena, double h,
                     const ContactLists& contacts, const Vec3* velocityBefore, Balls& balls) {
  forEach(contacts, [&]<class Partner>(Contact& c) {
    prepare<Partner>(settings, arena, velocityBefore, balls, c);
  });
  forEach(contacts, [&]<class Partner>(Contact& c) { warmStart<Partner>(balls, c); });
  for (int pass = 0; pass < settings.iterations; ++pass)
    forEach(contacts, [&]<class Partner>(Contact& c) {
      if (c.gap > 0) return;
      solveNormal<Partner>(balls, c);
      if (settings.friction > 0) solveTangent<Partner>(settings.friction, balls, c);
    });
  forEach(contacts, [&]<class Partner>(Contact& c) { shiftByContactForce<Partner>(h, balls, c); });
  forEach(contacts, [&]<class Partner>(Contact& c) { pushOut<Partner>(arena, h, balls, c); });
}

}  // namespace wells
