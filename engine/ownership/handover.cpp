#include "ownership/handover.h"

namespace wells {

PeerId nearerPeer(const Vec3& ball, PeerId self, std::span<const PeerWell> wells,
                  const HandoverRule& rule) {
  const PeerWell* nearest = nullptr;
  const PeerWell* own = nullptr;
  double nearestDistance = 0;
  double ownDistance = 0;
  for (const PeerWell& well : wells) {
    const double distance = length(well.position - ball);
    if (well.peer == self) {
      own = &well;
      ownDistance = distance;
    }
    if (!nearest || distance < nearestDistance ||
        (distance == nearestDistance && well.peer < nearest->peer)) {
      nearest = &well;
      nearestDistance = distance;
    }
  }
  if (!nearest || nearest->peer == self) return kNobody;
  if (own && nearestDistance >= rule.ratio * ownDistance - rule.margin) return kNobody;
  return nearest->peer;
}

HandoverWatch watch(const HandoverWatch& before, PeerId nearer, std::int64_t step) {
  if (nearer == before.nearer) return before;
  return {nearer, step};
}

bool isDue(const HandoverWatch& watch, std::int64_t step, const HandoverRule& rule) {
  return watch.nearer != kNobody && step - watch.since >= rule.dwell;
}

}  // namespace wells
