// What every engine is to the outside: World in, World out. Ours, the custom integrator of the 2017
// report and stock Bullet all stand behind it, so that tests, benchmarks and the peer run any of
// them on any scene.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "state/books.h"
#include "state/stage_clock.h"
#include "state/world.h"

namespace wells {

/// What an engine did in its last step.
struct StepCounts {
  std::int64_t candidatePairs = 0;  // pairs whose boxes overlap, ground and wall included
  std::int64_t contacts = 0;        // pairs that may touch within the step
  std::int64_t latePairs = 0;       // overlaps that the broadphase had not announced; must be 0

  // Which method moved the balls that could touch something.
  std::int64_t exactBalls = 0;      // exact impacts, rolling and sliding
  std::int64_t substepBalls = 0;    // sequential impulses over substeps
  std::int64_t directContacts = 0;  // of those, in islands solved directly; once for each substep
  std::int64_t unsolvedIslands =
      0;                        // small ones that the direct solver left to the passes, likewise
  std::int64_t impacts = 0;     // impulses at their own time within the step
  std::int64_t clusters = 0;    // instants at which several impacts hung together
  std::int64_t handedOver = 0;  // islands that began as exact and were left to the substeps
  std::int64_t asleep = 0;      // balls that sleep at the end of the step
  int threads = 1;              // that the step ran on
  std::int64_t flightStretches = 1;  // into which the flight of a step is divided (sharp wells)
};

/// For so many steps a crowd that exact impacts could not move goes by substeps.
inline constexpr std::uint8_t kCrowdSteps = 30;

/// What an engine remembers from one step to the next besides the World: with it, a run goes on
/// with the same bits.
struct StepperMemory {
  /// Impulses to start from.
  struct Contact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;                 // a ball, kGround or kWall
    double normalImpulse = 0;            // N s, > 0
    Vec3 tangentImpulse = Vec3::Zero();  // N s
    Vec3 rollingImpulse = Vec3::Zero();  // N m s
  };
  double substep = 0;                  // s, in which they arose; 0: none did
  std::vector<Contact> ballContacts;   // by (a, b)
  std::vector<Contact> arenaContacts;  // by (a, b)
  /// By ball: for so many steps more a crowd that it belongs to goes by substeps.
  std::vector<std::uint8_t> stepsInSubsteps;

  /// Who sleeps, and who has rested for how long (world/sleep.h). Lists by ball, or all empty.
  struct Rest {
    std::uint64_t conditions = 0;       // hash of what all who sleep rely on
    std::vector<std::uint32_t> group;   // the lowest of those that sleep with it; kAwake
    std::vector<std::uint32_t> steps;   // of those awake: for how long it has rested
    std::vector<double> speed;          // m/s, of those awake: more gathers speed
    std::vector<Vec3> position;         // m, of those asleep, where they fell asleep
    std::vector<Vec3> acceleration;     // m/s^2, of the fields, likewise
    std::vector<std::uint8_t> isGhost;  // 1: they were, likewise
  };
  static constexpr std::uint32_t kAwake = 0xffffffff;
  Rest rest;

  /// What the balls of the custom integrator bring along; each list by ball.
  struct Carried {
    std::vector<Vec3> position;      // m, where the last step left it
    std::vector<Vec3> velocity;      // m/s, likewise; a ball that differs was changed from outside
    std::vector<Vec3> lastVelocity;  // m/s, at the start of the last step
    std::vector<Vec3> force;         // N, of rolling, for the next step
  };
  Carried carried;
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
  /// between (another peer's states, a hand-over); states and roles of balls that may be asleep by
  /// World::setState(), setRole() and setBalls(), because nobody looks at those. Throws
  /// std::runtime_error where it would have to break a promise to go on (see
  /// Settings::mostImpacts), and std::invalid_argument for an unknown integrator; `world` is then
  /// as it was.
  virtual void step(World& world) = 0;

  /// Of the last step.
  virtual StepCounts counts() const { return {}; }

  /// Balls whose state is not finite, at the end of the last step: they stay as they are, touch
  /// nothing and are touched by nothing. Rising ids.
  virtual std::span<const std::uint32_t> quarantined() const { return {}; }

  /// From now on each step is booked. Costs time. False: this engine cannot.
  virtual bool openBooks() { return false; }

  /// Null before openBooks().
  virtual const Books* books() const { return nullptr; }

  /// From now on each step is clocked. Costs a little time. False: this engine cannot.
  virtual bool openStageClock() { return false; }

  /// Of the last step; null before openStageClock().
  virtual const StageTimes* stageTimes() const { return nullptr; }

  /// Null: this engine keeps what cannot be saved.
  virtual const StepperMemory* memory() const { return nullptr; }

  /// Goes on from `memory`, which belongs to the world that the next step is given.
  virtual void restore(const StepperMemory&) {}
};

}  // namespace wells
