#include "contacts/sequential_impulses.h"

#include <algorithm>

namespace wells {
namespace {

// Share of a remaining overlap between balls that one substep pushes out. All of it at once makes a
// heap hop: each push-out creates the neighbour's overlap. The arena does not give way: all.
template <class Partner>
constexpr double kPushOut = 0.6;
template <>
constexpr double kPushOut<ArenaPartner> = 1.0;

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
void pushApart(Balls& balls, const Contact& c, double impulse, const Ledger& ledger) {
  if (ledger) bookNormal(ledger, c, impulse, closingSpeed<Partner>(balls.velocity.data(), c));
  applyImpulse<Partner>(balls, c, -impulse * c.normal);
}

template <class Partner>
void rub(Balls& balls, const Contact& c, const Vec3& impulse, const Ledger& ledger) {
  if (ledger) bookTangent(ledger, c, impulse, slipVelocity<Partner>(balls, c));
  applyTangentImpulse<Partner>(balls, c, impulse);
}

template <class Partner>
void warmStart(Balls& balls, Contact& c, const Ledger& ledger) {
  if (c.normalImpulse == 0) return;
  c.tangentImpulse -= dot(c.tangentImpulse, c.normal) * c.normal;  // the normal has turned
  pushApart<Partner>(balls, c, c.normalImpulse, ledger);
  rub<Partner>(balls, c, c.tangentImpulse, ledger);
}

template <class Partner>
void solveNormal(Balls& balls, Contact& c, const Ledger& ledger) {
  const double closing = closingSpeed<Partner>(balls.velocity.data(), c);
  const double total = std::max(0.0, c.normalImpulse + normalMass(c) * (closing + c.bounceSpeed));
  const double change = total - c.normalImpulse;
  c.normalImpulse = total;
  pushApart<Partner>(balls, c, change, ledger);
}

template <class Partner>
void solveTangent(double friction, Balls& balls, Contact& c, const Ledger& ledger) {
  Vec3 total = c.tangentImpulse - tangentMass(c) * slipVelocity<Partner>(balls, c);
  const double limit = friction * c.normalImpulse;
  const double size = length(total);
  if (size > limit) total *= limit / size;
  const Vec3 change = total - c.tangentImpulse;
  c.tangentImpulse = total;
  rub<Partner>(balls, c, change, ledger);
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
  const Vec3 shift = (kPushOut<Partner> * depth * normalMass(c)) * c.normal;
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
                     const ContactLists& contacts, const Vec3* velocityBefore, Balls& balls,
                     const SubstepBooks* booking) {
  const Ledger ledger = booking ? booking->ledger : Ledger{};
  const auto placement = [&] {
    return placementOf(ledger, *booking->field, booking->end, booking->touching, balls);
  };
  forEach(contacts, [&]<class Partner>(Contact& c) {
    prepare<Partner>(settings, arena, velocityBefore, balls, c);
  });
  forEach(contacts, [&]<class Partner>(Contact& c) { warmStart<Partner>(balls, c, ledger); });
  for (int pass = 0; pass < settings.iterations; ++pass)
    forEach(contacts, [&]<class Partner>(Contact& c) {
      if (c.gap > 0) return;
      solveNormal<Partner>(balls, c, ledger);
      if (settings.friction > 0) solveTangent<Partner>(settings.friction, balls, c, ledger);
    });
  const Placement solved = booking ? placement() : Placement{};
  if (booking)
    for (const Contact& c : contacts.arena)
      bookArena(ledger, c, c.tangentImpulse - c.normalImpulse * c.normal, balls);
  forEach(contacts, [&]<class Partner>(Contact& c) { shiftByContactForce<Partner>(h, balls, c); });
  const Placement shifted = booking ? placement() : Placement{};
  forEach(contacts, [&]<class Partner>(Contact& c) { pushOut<Partner>(arena, h, balls, c); });
  if (!booking) return;
  const Placement pushed = placement();
  Books& books = *ledger.books;
  books.contacts += shifted.potential - solved.potential;
  books.pushOut += pushed.potential - shifted.potential;
  books.shifts.angular += pushed.angular - solved.angular;
}

}  // namespace wells
