#include "contacts/impacts.h"

#include <algorithm>
#include <cmath>

namespace wells {
namespace {

constexpr double kNoise = 1e-14;   // of the fastest ball: closing slower than that is rounding
constexpr int kMostSweeps = 1000;  // of the projected Gauss-Seidel, which ends when it is exact
constexpr double kSpinFactor = 1 / kInertiaFactor;

double inverseMass(const Balls& balls, std::uint32_t i) {
  return isBall(i) ? 1 / balls.mass[i] : 0;
}

void push(Balls& balls, const Contact& c, const Vec3& impulseOnA) {
  balls.velocity[c.a] += c.inverseMassA * impulseOnA;
  if (isBall(c.b)) balls.velocity[c.b] -= c.inverseMassB * impulseOnA;
}

double normalMass(const Contact& c) {
  return 1 / (c.inverseMassA + c.inverseMassB);
}

/// One round: all contacts that close, at once. Returns how many got an impulse.
std::int64_t reflect(double elasticity, double noise, std::span<Contact> contacts, Balls& balls) {
  bool any = false;
  for (Contact& c : contacts) {
    const double closing = closingSpeed(balls, c);
    c.impact = closing > noise;
    c.bounceSpeed = elasticity * closing;
    c.normalImpulse = 0;
    any = any || c.impact;
  }
  if (!any) return 0;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double largestChange = 0;
    for (Contact& c : contacts) {
      if (!c.impact) continue;
      const double missing = closingSpeed(balls, c) + c.bounceSpeed;
      const double total = std::max(0.0, c.normalImpulse + normalMass(c) * missing);
      const double change = total - c.normalImpulse;
      if (change == 0) continue;
      c.normalImpulse = total;
      push(balls, c, -change * c.normal);
      largestChange = std::max(largestChange, std::abs(change) * (c.inverseMassA + c.inverseMassB));
    }
    if (largestChange <= 0.01 * noise) break;
  }
  return std::count_if(contacts.begin(), contacts.end(),
                       [](const Contact& c) { return c.impact && c.normalImpulse > 0; });
}

void rub(double friction, std::span<const Contact> contacts, Balls& balls) {
  for (const Contact& c : contacts) {
    if (!c.impact || c.normalImpulse == 0) continue;
    Vec3 slip = balls.velocity[c.a];
    Vec3 surfaceSpin = balls.radius[c.a] * balls.spin[c.a];
    if (isBall(c.b)) {
      slip -= balls.velocity[c.b];
      surfaceSpin += balls.radius[c.b] * balls.spin[c.b];
    }
    slip += cross(surfaceSpin, c.normal);
    slip -= dot(slip, c.normal) * c.normal;
    Vec3 impulse = -normalMass(c) / (1 + kSpinFactor) * slip;
    const double size = length(impulse);
    const double limit = friction * c.normalImpulse;
    if (size > limit) impulse *= limit / size;
    push(balls, c, impulse);
    const Vec3 torque = kSpinFactor * cross(c.normal, impulse);
    balls.spin[c.a] += c.inverseMassA / balls.radius[c.a] * torque;
    if (isBall(c.b)) balls.spin[c.b] += c.inverseMassB / balls.radius[c.b] * torque;
  }
}

}  // namespace

std::int64_t resolveImpacts(double elasticity, double friction, std::span<Contact> contacts,
                            Balls& balls) {
  double fastest = 0;
  for (Contact& c : contacts) {
    c.inverseMassA = inverseMass(balls, c.a);
    c.inverseMassB = inverseMass(balls, c.b);
    fastest = std::max(fastest, length(balls.velocity[c.a]));
    if (isBall(c.b)) fastest = std::max(fastest, length(balls.velocity[c.b]));
  }
  const double noise = kNoise * fastest;
  std::int64_t impulses = 0;
  for (int round = 0; round < kMostReflections; ++round) {
    const std::int64_t given = reflect(elasticity, noise, contacts, balls);
    if (given == 0) return impulses;
    impulses += given;
    if (friction > 0) rub(friction, contacts, balls);
  }
  if (elasticity < 1) impulses += reflect(0, noise, contacts, balls);
  return impulses;
}

}  // namespace wells
