#include "contacts/motion_choice.h"

#include <algorithm>

namespace wells {
namespace {

/// All m/s^2. `resistance` is b/r N.
struct Limits {
  double friction;
  double resistance;
};

Limits limitsOf(const PathModel& model, const Path& path, const Load& load) {
  return {model.friction * load.pressing, model.rollingResistance / path.radius * load.pressing};
}

/// Whether friction suffices to roll against a resistance to that direction (not a unit vector).
bool canRoll(const Limits& limits, const Load& load, Flat direction) {
  Flat pull = load.slipPull;
  const double size = length(direction);
  if (limits.resistance > 0 && size > 0)
    pull = pull + kSpinning * limits.resistance / size * direction;
  return kHolding * length(pull) <= limits.friction;
}

/// Of a ball without slip and spin that is pulled too strongly to rest.
Motion setInMotion(const Limits& limits, const Load& load) {
  if (limits.friction <= limits.resistance) return Motion::Skidding;
  return canRoll(limits, load, load.pull) ? Motion::Rolling : Motion::Sliding;
}

/// Whether resistance suffices to keep a ball that slips from turning.
bool canSkid(const Limits& limits, const Path& path, const Held& held, const Load& load) {
  if (path.surface == kGround) return limits.friction <= limits.resistance;
  const double slip = length(held.slip);
  const Flat friction = slip > 0 ? -limits.friction / slip * held.slip : Flat{};
  const Flat needed = friction - kInertiaFactor * (load.pull - load.slipPull);
  return length(needed) <= limits.resistance;
}

}  // namespace

Motion motionOf(const PathModel& model, const Path& path, const HeldMotion& arriving) {
  const Held& held = arriving.start();
  const Load load = arriving.loadOn(held, path.start);
  const Limits limits = limitsOf(model, path, load);
  const double noise = arriving.noise();
  const bool slips = model.friction == 0 || length(held.slip) > noise;
  if (model.rollingResistance == 0)
    return !slips && canRoll(limits, load, {}) ? Motion::Rolling : Motion::Sliding;
  const Flat lag = held.velocity - held.slip;
  const bool turns = length(lag) > noise;
  if (slips)
    return !turns && canSkid(limits, path, held, load) ? Motion::Skidding : Motion::Sliding;
  if (turns) return canRoll(limits, load, lag) ? Motion::Rolling : Motion::Sliding;
  return length(load.pull) <= std::min(limits.friction, limits.resistance)
             ? Motion::Resting
             : setInMotion(limits, load);
}

Motion motionWithoutGrip(const PathModel& model, const Path& path, const Load& load) {
  return path.motion == Motion::Resting ? setInMotion(limitsOf(model, path, load), load)
                                        : Motion::Sliding;
}

}  // namespace wells
