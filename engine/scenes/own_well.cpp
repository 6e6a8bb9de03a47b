#include "scenes/own_well.h"

#include <cmath>

#include "math/elementary.h"

namespace wells {
namespace {

constexpr double kStandardGravity = 9.81;  // m/s^2

}  // namespace

double defaultWellStrength(const Arena& arena, double softening) {
  const double d = arena.radius / 2;
  const double s2 = d * d + softening * softening;
  return kStandardGravity / 8 * s2 * std::sqrt(s2) / d;
}

Vec3 defaultWellPosition(const Arena& arena, double ballRadius, PeerId peer) {
  double turns = 0;
  double digit = 0.5;
  for (auto n = static_cast<unsigned>(value(peer) - 1); n != 0; n >>= 1, digit /= 2)
    if (n & 1u) turns += digit;
  const SinCos angle = sinCosOfTurns(turns);
  const double r = arena.radius / 2;
  return arena.center + Vec3{r * angle.cos, ballRadius, r * angle.sin};
}

WellTrack defaultWell(const Arena& arena, double ballRadius, PeerId peer, double softening) {
  return {.keyframes = {{.step = 0,
                         .position = defaultWellPosition(arena, ballRadius, peer),
                         .strength = defaultWellStrength(arena, softening)}},
          .softening = softening,
          .peer = peer};
}

}  // namespace wells
