#include "state/wells.h"

#include <algorithm>

#include "math/elementary.h"

namespace wells {

Well wellAt(const WellTrack& track, std::int64_t step, double dt) {
  const auto& keys = track.keyframes;
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), step,
                       [](std::int64_t s, const WellKeyframe& key) { return s < key.step; });
  Well well{.softening = track.softening, .peer = track.peer};
  if (next == keys.begin()) {
    well.position = next->position;
    well.strength = next->strength;
    return well;
  }
  const WellKeyframe& from = *(next - 1);
  well.strength = from.strength;
  if (next == keys.end()) {
    well.position = from.position;
    return well;
  }
  const double steps = static_cast<double>(next->step - from.step);
  const Vec3 perStep = (next->position - from.position) / steps;
  well.position = from.position + perStep * static_cast<double>(step - from.step);
  well.velocity = perStep / dt;
  return well;
}

Vec3 positionOnCircle(const CirclePath& path, double t) {
  const SinCos angle = sinCosOfTurns(path.phase + t / path.period);
  return path.center + path.radius * Vec3{angle.cos, 0, angle.sin};
}

}  // namespace wells
