// Who takes the balls of an owner that is gone, and when: everyone may, the nearest first, so that
// normally one does and nobody has to agree on it. Two who adopt at once do no harm: their versions
// differ, and the greater wins.
#pragma once

#include <span>

#include "ownership/handover.h"

namespace wells {

/// How many of `wells` (of the living peers, that of `self` among them) come before self: the
/// nearer ones and, at the same distance from `ball`, the lower ids.
std::size_t adoptionRank(const Vec3& ball, PeerId self, std::span<const PeerWell> wells);

/// How long the peer of this rank waits after the lease has ended, s: evenly spread over less than
/// one more lease, so that everything is owned again within two leases of the last sign of life.
/// rank < candidates, the number of living peers.
double adoptionWait(std::size_t rank, std::size_t candidates, double lease);

}  // namespace wells
