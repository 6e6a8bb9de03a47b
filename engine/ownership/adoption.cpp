#include "ownership/adoption.h"

#include <algorithm>
#include <limits>

namespace wells {

std::size_t adoptionRank(const Vec3& ball, PeerId self, std::span<const PeerWell> wells) {
  const auto distance = [&](const PeerWell& well) { return squaredLength(well.position - ball); };
  const auto own = std::ranges::find(wells, self, &PeerWell::peer);
  // Without a well: after all who have one.
  const double ownDistance =
      own == wells.end() ? std::numeric_limits<double>::infinity() : distance(*own);
  return static_cast<std::size_t>(std::ranges::count_if(wells, [&](const PeerWell& well) {
    const double other = distance(well);
    return other < ownDistance || (other == ownDistance && well.peer < self);
  }));
}

double adoptionWait(std::size_t rank, std::size_t candidates, double lease) {
  return lease * static_cast<double>(rank) / static_cast<double>(candidates + 1);
}

}  // namespace wells
