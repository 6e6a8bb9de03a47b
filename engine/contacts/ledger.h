// Writes into Books what impulses and paths do. A ledger without books writes nothing and costs a
// comparison.
//
// The work of an impulse J is J . (u + u') / 2, u and u' the relative velocity at the contact
// before and after it, which is exact and has no cancellation.
#pragma once

#include <span>

#include "contacts/partners.h"
#include "contacts/path.h"
#include "state/books.h"

namespace wells {

struct Ledger {
  Books* books = nullptr;      // null: nothing is written
  Vec3 center = Vec3::Zero();  // m, of the arena: angular momentum is about it

  explicit operator bool() const { return books != nullptr; }
};

/// A normal impulse of `size` (N s, pushing apart) is given to a contact that closes at `closing`.
inline void bookNormal(const Ledger& ledger, const Contact& c, double size, double closing) {
  ledger.books->contacts -= size * (closing - size * (c.inverseMassA + c.inverseMassB) / 2);
}

/// A tangent impulse on a is given to a contact that slips by `slip`.
inline void bookTangent(const Ledger& ledger, const Contact& c, const Vec3& impulse,
                        const Vec3& slip) {
  ledger.books->friction += dot(impulse, slip + impulse / (2 * tangentMass(c)));
  // Action and reaction act on two surfaces that an overlap keeps apart.
  if (isBall(c.b)) ledger.books->shifts.angular -= c.gap * cross(c.normal, impulse);
}

/// A torque impulse (N m s) on a is given to a contact that rolls by `rolling` (rad/s).
inline void bookRolling(const Ledger& ledger, const Vec3& torque, const Vec3& rolling,
                        double inverseInertia) {
  ledger.books->friction += dot(torque, rolling + (inverseInertia / 2) * torque);
}

/// The impulses of a contact between balls acted along a normal that is not their line of centres,
/// or across it.
void bookTurnedNormal(const Ledger& ledger, const Contact& c, const Balls& balls);

/// Ground or wall gave ball c.a the impulse (N s).
void bookArena(const Ledger& ledger, const Contact& c, const Vec3& impulse, const Balls& balls);

/// A ball of `mass` follows the path until then.
void bookPath(const Ledger& ledger, const PathModel& model, const Path& path, double mass,
              double until);

/// A surface takes hold of a ball that had `before`: the last of a slip ends, by rounding or a
/// little more.
void bookHold(const Ledger& ledger, const BallState& before, const Path& held, double mass);

/// Energy (J) and angular momentum (kg m^2/s) that depend on where the given balls are: what
/// correcting their positions changes.
struct Placement {
  double potential = 0;
  Vec3 angular = Vec3::Zero();
};

Placement placementOf(const Ledger& ledger, const Field& field, double t,
                      std::span<const std::uint32_t> chosen, const Balls& balls);

}  // namespace wells
