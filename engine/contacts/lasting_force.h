// What the force of a contact that lasts does to positions within a substep, beside what its
// impulse does to velocities.
//
// A contact that rests carried its impulse evenly over the substep: a constant force moves a ball
// by half of what the full change of velocity would. With it, a resting ball stays where it is and
// a sliding one brakes exactly. An impact is an instant, and gets none; what suddenly exceeds the
// impulse of the substep before passes on an impact from elsewhere. Where the balls came to rest in
// the substep, the force did not act all the time. Contact::share says for how much of it.
#pragma once

#include <span>

#include "contacts/partners.h"

namespace wells {

/// The share with which the shift raises the potential by no more than the impulse took from the
/// motion:
///   share (closing after flight - closing before) <= closing after flight + closing resolved.
double shareAlone(const Contact& c, const Balls& balls);

/// Sets the shares of an island that is solved: what rests gets the same throughout, so that forces
/// in balance shift nothing. Again the shifts raise no more than the impulses took.
void shareTogether(std::span<Contact* const> island, const Balls& balls);

/// J, what normal impulses and their shifts did: J (c + c') / 2 of all contacts is exact, c and c'
/// the closing speeds before and after all impulses, whatever the order in which they were found.
double workOfNormals(std::span<const Contact> contacts, const Balls& balls);

/// Shifts the balls by what the force did in a substep of h seconds. Nothing bounds what friction
/// would add by its shift where forces move a ball far within the substep; there it shifts nothing.
template <class Partner>
void shiftByContactForce(double h, Balls& balls, const Contact& c) {
  if (c.share == 0) return;
  const Vec3 push = -c.normalImpulse * c.normal;
  const Vec3 shift = (c.isCoarse ? push : Vec3(push + c.tangentImpulse)) * (c.share * h / 2);
  balls.position[c.a] += c.inverseMassA * shift;
  Partner::shift(balls, c, -shift);
}

}  // namespace wells
