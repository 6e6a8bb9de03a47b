// The contacts of a crowd in one substep, kContactLanes side by side, in vector code that is chosen
// for the processor at start-up. Lanes are contacts that share no ball, and nothing is summed
// across lanes, so every instruction set computes the same bits. The physics is that of
// sequential_impulses.h for islands that are not solved directly.
#pragma once

#include <span>

#include "broadphase/ball_pair.h"
#include "contacts/crowd_arrays.h"
#include "state/arena.h"

namespace wells {

/// What the contacts of a kernel's call are with.
enum class PartnerKind : std::uint8_t { Ball, Ground, Wall };

/// The partner of a contact with the arena, as pairs have it.
constexpr std::uint32_t partnerOf(PartnerKind kind) {
  return kind == PartnerKind::Ground ? kGround : kWall;
}

/// The arrays of a crowd. Lanes of a block that are not in use have two idle balls, out of reach of
/// each other, and an idle pair; each thread its own, behind those of the crowd.
struct CrowdArrays {
  Place* place;
  Momentum* momentum;
  const Gained* gained;
  const std::uint32_t* ids;  // in the world
  const IndexPair* pairs;
  LastingImpulse* lasting;   // by pair
  std::uint32_t* touchedIn;  // by pair, the last substep in which it touched
  std::uint32_t idleBall;    // and the one behind it
  std::uint32_t idlePair;
};

struct CrowdRules {
  double h;  // s, of the substep
  double elasticity;
  double friction;
  Arena arena;
  std::uint32_t substep;  // 1 .. in the step; pairs that touched in the one before rest
};

struct CrowdSubstep {
  bool anyImpact = false;
  double closing = 0;  // m/s, the most that forces built up, or an impact closes with
};

/// Tells by pair, 1 or 0, whether two balls come near each other within `duration` s if nothing
/// deflects them: closer than kFarGap.
void findNear(double duration, const Place* places, const Momentum* momenta,
              std::span<const IndexPair> pairs, std::uint8_t* isNear);

/// Lists those of the pairs first .. last - 1 that touch; returns how many.
std::size_t findTouching(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                         std::uint32_t first, std::uint32_t last, std::uint32_t* touching);

/// Fills blocks with the pairs listed, from the state before any impulse. `blocks` has room for
/// all, in blocks of kContactLanes.
void prepareContacts(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                     std::span<const std::uint32_t> touching, ContactBlock* blocks,
                     ContactFlight* flights, CrowdSubstep& substep);

/// Gives the balls the impulses that last.
void startFromLasting(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                      std::span<const ContactBlock> blocks);

enum class Watch : std::uint8_t { No, Changes };

/// One pass of sequential impulses. Returns the greatest change of a relative velocity (m/s) if it
/// is to watch, else 0.
double solveContacts(PartnerKind partner, Watch watch, const CrowdRules& rules,
                     const CrowdArrays& arrays, std::span<ContactBlock> blocks);

/// Shifts the balls by what the forces of contacts that last did, and keeps the impulses.
void shiftByForces(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                   std::span<const ContactBlock> blocks, const ContactFlight* flights);

void pushOverlapsOut(PartnerKind partner, const CrowdRules& rules, const CrowdArrays& arrays,
                     std::span<const ContactBlock> blocks);

}  // namespace wells
