// To whom a ball should be handed: to the peer whose well is nearest. Hysteresis in distance and in
// time keeps a ball on the border from going back and forth.
#pragma once

#include <cstdint>
#include <span>

#include "math/ids.h"
#include "math/vector.h"

namespace wells {

/// Where the well of a living peer stands.
struct PeerWell {
  PeerId peer = kNobody;
  Vec3 position = Vec3::Zero();  // m
};

/// Another well counts as nearer when its distance is below ratio * own distance - margin, and must
/// be so for `dwell` steps on end.
struct HandoverRule {
  double ratio = 0.9;      // in (0, 1]
  double margin = 0.5;     // m, > 0
  std::int64_t dwell = 6;  // steps, >= 0; a ball that crosses the border for less stays
};

/// What the owner remembers of a ball between two looks at it.
struct HandoverWatch {
  PeerId nearer = kNobody;  // whose well has been nearer, by the rule ...
  std::int64_t since = 0;   // ... since this step

  bool operator==(const HandoverWatch&) const = default;
};

/// The peer whose well is nearest to `ball` if it is nearer than that of `self` by the rule, else
/// nobody. Equal distances go to the lowest id. A self without a well gives to the nearest.
PeerId nearerPeer(const Vec3& ball, PeerId self, std::span<const PeerWell> wells,
                  const HandoverRule& rule);

/// The watch after a look at `step` that found `nearer`.
HandoverWatch watch(const HandoverWatch& before, PeerId nearer, std::int64_t step);

/// True when the ball is to be offered to watch.nearer.
bool isDue(const HandoverWatch& watch, std::int64_t step, const HandoverRule& rule);

}  // namespace wells
