#include "contacts/impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

constexpr int kMostSweeps = 1000;  // of the projected Gauss-Seidel, which ends when it is exact

/// One round: all contacts that close, at once. Returns how many got an impulse.
std::int64_t reflect(double elasticity, double noise, std::span<Contact> contacts, Balls& balls,
                     const Ledger& ledger) {
  bool any = false;
  for (Contact& c : contacts) {
    const double closing = closingSpeed(balls, c);
    c.impact = closing > noise;
    c.bounceSpeed = elasticity * closing;
    c.normalImpulse = 0;
    any = any || c.impact;
  }
  if (!any) return 0;
  double lastChange = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double largestChange = 0;
    for (Contact& c : contacts) {
      if (!c.impact) continue;
      const double closing = closingSpeed(balls, c);
      const double missing = closing + c.bounceSpeed;
      const double total = std::max(0.0, c.normalImpulse + normalMass(c) * missing);
      const double change = total - c.normalImpulse;
      if (change == 0) continue;
      c.normalImpulse = total;
      withPartner(c, [&]<class Partner>() { applyImpulse<Partner>(balls, c, -change * c.normal); });
      if (ledger) bookNormal(ledger, c, change, closing);
      largestChange = std::max(largestChange, std::abs(change) * (c.inverseMassA + c.inverseMassB));
    }
    // Changes that are rounding and shrink no more would go to and fro.
    if (largestChange <= 0.01 * noise || (largestChange <= noise && largestChange >= lastChange))
      break;
    lastChange = largestChange;
  }
  const auto isGiven = [](const Contact& c) { return c.impact && c.normalImpulse > 0; };
  if (ledger)
    for (const Contact& c : contacts)
      if (isGiven(c) && !isBall(c.b)) bookArena(ledger, c, -c.normalImpulse * c.normal, balls);
  return std::count_if(contacts.begin(), contacts.end(), isGiven);
}

template <class Partner>
void rub(double friction, const Contact& c, Balls& balls, const Ledger& ledger) {
  const Vec3 slip = slipVelocity<Partner>(balls, c);
  Vec3 impulse = -tangentMass(c) * slip;
  const double size = length(impulse);
  const double limit = friction * c.normalImpulse;
  if (size > limit) impulse *= limit / size;
  applyTangentImpulse<Partner>(balls, c, impulse);
  if (!ledger) return;
  bookTangent(ledger, c, impulse, slip);
  if (!isBall(c.b)) bookArena(ledger, c, impulse, balls);
}

}  // namespace

std::int64_t resolveImpacts(double elasticity, double friction, std::span<Contact> contacts,
                            Balls& balls, const Ledger& ledger) {
  double fastest = 0;
  for (Contact& c : contacts) {
    c.inverseMassA = 1 / balls.mass[c.a];
    c.inverseMassB = isBall(c.b) ? 1 / balls.mass[c.b] : 0;
    fastest = std::max(fastest, length(balls.velocity[c.a]));
    if (isBall(c.b)) fastest = std::max(fastest, length(balls.velocity[c.b]));
  }
  const double noise = kClosingNoise * fastest;
  std::int64_t impulses = 0;
  for (int round = 0; round < kMostReflections; ++round) {
    const std::int64_t given = reflect(elasticity, noise, contacts, balls, ledger);
    if (given == 0) return impulses;
    impulses += given;
    if (friction == 0) continue;
    for (const Contact& c : contacts)
      if (c.impact && c.normalImpulse > 0)
        withPartner(c, [&]<class Partner>() { rub<Partner>(friction, c, balls, ledger); });
  }
  if (elasticity < 1) impulses += reflect(0, noise, contacts, balls, ledger);
  return impulses;
}

}  // namespace wells
