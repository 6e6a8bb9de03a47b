// What every engine is to the outside: World in, World out. Ours, the custom integrator of the 2017
// report and stock Bullet all stand behind it, so that tests, benchmarks and the peer run any of
// them on any scene.
#pragma once

#include <cstdint>
#include <string>

#include "state/world.h"

namespace wells {

/// What an engine did in its last step.
struct StepCounts {
  std::int64_t candidatePairs = 0;  // pairs whose boxes overlap, ground and wall included
  std::int64_t contacts = 0;        // contacts given to the solver (gap small or negative)
  std::int64_t impacts = 0;         // resolved at their own time within the step
  std::int64_t exactBalls = 0;      // balls whose contacts were all such impacts
  std::int64_t latePairs = 0;       // overlaps that the broadphase had not announced; must be 0
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// The `--engine` name: ours, bullet, reference-euler, ...
  virtual std::string name() const = 0;

  /// The integrator and the contact method in use, for reports.
  virtual std::string integrator() const = 0;
  virtual std::string contactMethod() const = 0;

  /// Advances `world` by one step of world.settings.dt. The same world must be passed each time,
  /// but its balls' states, roles, tracks and settings may have been changed from outside in
  /// between (another peer's states, a hand-over).
  virtual void step(World& world) = 0;

  /// Of the last step.
  virtual StepCounts counts() const { return {}; }
};

}  // namespace wells
