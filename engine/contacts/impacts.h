// Impacts at one instant: velocities and spins jump, positions stay.
//
// Contacts of one instant that share balls are resolved together, by generalised reflections
// (Smith, Kaufman, Vouga, Tamstorf & Grinspun, "Reflections on Simultaneous Impact", SIGGRAPH
// 2012): all contacts that close are reflected at once, by the impulses lambda >= 0 with
//   closing after = -e closing before  where lambda > 0,  and no faster than that elsewhere,
// and again while any contact closes. Symmetric clusters stay symmetric, e = 1 keeps the energy,
// and momentum passes through a row of touching balls to its end. Coulomb friction follows each
// round, with spin, contact by contact.
#pragma once

#include <cstdint>
#include <span>

#include "contacts/ledger.h"

namespace wells {

/// Resolves contacts whose normals are set (gaps do not matter). Order does not matter but for
/// friction within a cluster. For e < 1 what still closes after kMostReflections rounds is brought
/// to rest. Returns how many impulses were given: contacts, summed over the rounds.
std::int64_t resolveImpacts(double elasticity, double friction, std::span<Contact> contacts,
                            Balls& balls, const Ledger& ledger = {});

inline constexpr int kMostReflections = 200;

}  // namespace wells
