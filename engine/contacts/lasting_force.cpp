#include "contacts/lasting_force.h"

#include <algorithm>

namespace wells {
namespace {

/// Twice the work that the impulse took from the motion along the normal.
double lossOf(const Contact& c, const Balls& balls) {
  return c.normalImpulse * (c.closingFlown + closingSpeed(balls, c));
}

}  // namespace

double shareAlone(const Contact& c, const Balls& balls) {
  if (c.impact || c.normalImpulse == 0) return 0;
  if (c.builtUp <= 0) return 1;
  return std::clamp((c.closingFlown + closingSpeed(balls, c)) / c.builtUp, 0.0, 1.0);
}

void shareTogether(std::span<Contact* const> island, const Balls& balls) {
  double lost = 0;
  double raised = 0;
  for (Contact* c : island) {
    c->share = c->restedImpulse > 0 && c->normalImpulse > 0
                   ? std::min(1.0, kRestFactor * c->restedImpulse / c->normalImpulse)
                   : shareAlone(*c, balls);
    if (c->impact) continue;
    lost += lossOf(*c, balls);
    raised += c->normalImpulse * c->share * c->builtUp;
  }
  if (raised <= 0) return;
  const double part = std::clamp(lost / raised, 0.0, 1.0);
  for (Contact* c : island) c->share *= part;
}

double workOfNormals(std::span<const Contact> contacts, const Balls& balls) {
  double sum = 0;
  for (const Contact& c : contacts)
    if (c.normalImpulse > 0) sum -= (lossOf(c, balls) - c.normalImpulse * c.share * c.builtUp) / 2;
  return sum;
}

}  // namespace wells
