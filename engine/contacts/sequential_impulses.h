// The contacts of a substep: small islands solved directly, the others by sequential impulses: one
// contact after another, a few times over, each impulse accumulated and clamped (Catto, "Iterative
// Dynamics with Temporal Coherence", GDC 2005; substeps instead of many iterations: Macklin et al.,
// "Small Steps in Physics Simulation", SCA 2019). First order in time through an impact: it is
// noticed at the end of its substep.
#pragma once

#include <span>

#include "contacts/direct_solver.h"
#include "contacts/ledger.h"
#include "contacts/touching_islands.h"
#include "state/settings.h"
#include "state/stage_clock.h"

namespace wells {

/// The contacts that may close during a step, those between balls apart from those with the arena.
/// Order is the order of resolution: the arena comes last, because its word is final.
struct ContactLists {
  std::span<Contact> balls;
  std::span<Contact> arena;
};

/// What booking a substep takes.
struct SubstepBooks {
  Books* books;
  const Field* field;
  double end;                               // s since the start of the step
  std::span<const std::uint32_t> touching;  // all balls of the contacts, each once
};

/// What resolving works with; kept, so that a warm substep takes no memory.
struct ContactWorkspace {
  TouchingIslands islands;
  DirectSolver direct;
  StageClock* clock = nullptr;  // null: nobody asks where the time goes
};

struct ResolvedCounts {
  std::int64_t direct = 0;    // contacts of islands that were solved directly
  std::int64_t unsolved = 0;  // small islands that the direct solver had to leave as it found them
};

/// Ends a substep of h seconds: the balls have flown it without regard to each other, and
/// `velocityBefore` (by ball) is what they had at its start. Changes velocities and spins so that
/// no contact closes, with
///  - restitution: a contact that closes faster than kRestFactor times the speed which forces gave
///    one of its balls within the substep bounces with e times its closing speed; a slower one
///    rests, and so does what rested before. Where no force acts, every contact bounces;
///  - Coulomb friction with spin: the tangent impulse brings the surfaces to rest if
///    mu times the normal impulse suffices, else it has that size;
///  - rolling resistance, but for contacts that bounce: a torque, equal and opposite on both,
///  brings
///    the rolling part of the relative angular velocity to rest if its impulse need not be more
///    than settings.rollingResistance times the normal impulse, else it has that size;
/// and positions so that a force of contact acts over the substep as a constant force would, and
/// what overlap remains is pushed out, but for a little in islands that are not solved directly.
/// Push-out changes no velocity.
/// `booking` may be null. Starts from the impulses that `contacts` hold from the substep before
/// (zero is fine) and leaves the new ones there.
ResolvedCounts resolveContacts(const Settings& settings, const Arena& arena, double h,
                               const ContactLists& contacts, const Vec3* velocityBefore,
                               Balls& balls, ContactWorkspace& workspace,
                               const SubstepBooks* booking = nullptr);

}  // namespace wells
