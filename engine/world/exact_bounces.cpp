// Bounces of one ball alone on ground or wall: when their series has come to its end.
#include "contacts/held_motion.h"
#include "world/exact_flight.h"

namespace wells {

ExactFlight::Bounce ExactFlight::bounceOfLoneBall(const StepInput& in, double time,
                                                  const Balls& balls) const {
  bool isLast = true;
  for (const Contact& c : cluster_) {
    if (isBall(c.b)) return Bounce::OfMany;
    if (cluster_.size() > 1 && !(closingSpeed(balls, c) > 0)) continue;
    const double pressing = pressingOn(in, time, c, balls);
    if (!(pressing > 0)) return Bounce::OfMany;
    isLast = isLast && settles(*in.model.arena, in.settings.elasticity, pressing, c, balls);
  }
  return isLast ? Bounce::Last : Bounce::OneOfASeries;
}

double ExactFlight::pressingOn(const StepInput& in, double time, const Contact& c,
                               const Balls& balls) {
  return loadOn(in.model, {balls.state(c.a), time, balls.radius[c.a], Motion::Flying, c.b}, time)
      .pressing;
}

// The flights that are left last 2 e v / (N (1 - e)) in all, N the pressing acceleration; the next
// one rises by (e v)^2 / (2 N).
bool ExactFlight::settles(const Arena& arena, double elasticity, double pressing, const Contact& c,
                          const Balls& balls) const {
  const double after = elasticity * closingSpeed(balls, c);
  return 2 * after <= kSettlingTime * dt_ * pressing * (1 - elasticity) ||
         (elasticity < 1 && isTooLow(arena, after, pressing, c, balls));
}

bool ExactFlight::isTooLow(const Arena& arena, double rising, double pressing, const Contact& c,
                           const Balls& balls) {
  const double size = c.b == kGround ? std::abs(balls.position[c.a].y()) + balls.radius[c.a]
                                     : length(arena.center) + arena.radius;
  return rising * rising <= 2 * pressing * kSettlingHeight * size;
}

void ExactFlight::endHops(const StepInput& in, double time, Balls& balls) {
  for (const Contact& c : cluster_) {
    const double closing = closingSpeed(balls, c);
    if (!(closing < 0)) continue;
    const double pressing = pressingOn(in, time, c, balls);
    if (!(pressing > 0) || !isTooLow(*in.model.arena, closing, pressing, c, balls)) continue;
    const double size = closing / c.inverseMassA;
    applyImpulse<ArenaPartner>(balls, c, -size * c.normal);
    if (!ledger_) continue;
    bookNormal(ledger_, c, size, closing);
    bookArena(ledger_, c, -size * c.normal, balls);
  }
}

}  // namespace wells
