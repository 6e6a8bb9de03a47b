// Sleep: islands of balls at rest stand still to the bit and cost nothing, until something wakes
// them. This class decides who sleeps; it moves no ball.
//
// A ball rests while it is no faster (|v| + r |w|) than Settings::sleepSpeed, if a lasting contact
// of the substeps presses it; any other must stand still exactly, because its motion is computed
// without noise. An island (what is pressed together, or could touch within a step) falls asleep
// when all its balls have rested for kRestTime and do not gather speed: none is now faster than the
// fastest was in the first half of that time, or later than it was up to kRestTime ago. What stands
// in an unstable balance gathers speed, so it stays awake, however slowly it begins to fall.
// Falling asleep sets velocities to zero, and is booked.
//
// An island wakes, in the step in which it must,
//  - when a ball that is awake may touch one of its balls;
//  - when the fields' acceleration of one of its balls is not what it was when it fell asleep: by
//    more than sleepSpeed / kRestTime if lasting contacts press it, else at all (looked at when a
//    well has moved or changed);
//  - when the state or the role of one of its balls has been changed (World::setState, setRole). A
//    ghost may be set within sleepSpeed kRestTime of where it fell asleep, no faster than
//    sleepSpeed: its owner's noise does not wake it;
//  - with all others when the settings, the arena or the number of balls change, or time jumps.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "broadphase/resting_boxes.h"
#include "forces/field.h"
#include "state/books.h"
#include "state/stepper.h"
#include "state/world.h"
#include "world/candidates.h"
#include "world/contact_memory.h"

namespace wells {

inline constexpr double kRestTime = 0.5;  // s, of simulated time; at least two steps

class Sleep {
 public:
  /// Of the step at hand, or that comes next: rising ids.
  std::span<const std::uint32_t> awake() const { return awake_; }
  std::size_t asleep() const { return group_.size() - awake_.size(); }

  // In the order of a step. `memory` has the impulses of those awake; those of an island that
  // sleeps are kept here. O(awake), unless said.

  /// Takes note of all that has changed since the last step, and clears world.changed. Where wells
  /// have changed, O(asleep).
  void begin(World& world, const Field& field, ContactMemory& memory);

  /// Wakes whom those awake may touch, moving as they do, and whom those may touch.
  void wakeAhead(const World& world, const Field& field, ContactMemory& memory);

  /// After an attempt at the step, in which balls that began with start[i] may have been hit: wakes
  /// whom these may have touched. True: somebody is awake now who took no part.
  bool wakeAround(const World& world, std::span<const BallState> start, const Field& field,
                  ContactMemory& memory);

  /// By the last wakeAround(); in no particular order.
  std::span<const std::uint32_t> woken() const { return woken_; }

  /// Lets fall asleep whoever has rested, at the end of a step, whose candidates these were.
  void end(World& world, const Field& field, const Candidates& candidates, Books& books,
           ContactMemory& memory);

  /// In the last end(). Rising ids.
  std::span<const std::uint32_t> fallenAsleep() const { return fallen_; }

  /// What the memory of an engine needs; `contacts` gets the impulses that are kept here.
  void save(StepperMemory::Rest& rest, ContactMemory& contacts) const;
  /// `contacts` has all impulses; those of islands that sleep are taken out.
  void restore(const StepperMemory::Rest& rest, ContactMemory& contacts);

 private:
  static constexpr std::uint32_t kAwake = StepperMemory::kAwake;

  struct Group {
    std::vector<std::uint32_t> balls;
    std::vector<StepperMemory::Contact> contacts;
  };
  /// Where a ball may get to in a step: along `path`, give or take `slack`.
  struct Sweep {
    std::uint32_t ball;
    Vec3 start;    // m
    Vec3 path;     // m
    double slack;  // m
  };

  /// Of the scratch.
  void makeRoom(std::size_t size);
  void wakeAll(const World& world, ContactMemory& memory);
  void wakeChanged(const World& world);
  void wakePulled(const World& world, const Field& field);
  bool isUnchanged(const World& world, std::uint32_t ball) const;
  bool isPulledAnew(const World& world, const Field& field, const Group& group) const;
  void wakeMet(const World& world, const Sweep& sweep);
  void wakeMetByWoken(const World& world, const Field& field, ContactMemory& memory);
  void wake(std::uint32_t group);
  void finishWaking(ContactMemory& memory);
  void giveBack(ContactMemory& memory);

  /// Sets slow_, and steps_ of those that were slow and are not.
  void findSlow(const World& world);
  bool anyHasRested(const World& world, const ContactMemory& memory);
  void findIslands(const World& world, const Field& field, const Candidates& candidates,
                   const ContactMemory& memory);
  void letSleep(World& world, const Field& field, std::uint32_t ball, std::uint32_t group,
                Books& books);
  void takeContacts(ContactMemory& memory);

  // By ball.
  std::vector<std::uint32_t> group_;   // the lowest ball of its island; or kAwake
  std::vector<std::uint32_t> steps_;   // awake: for how long it has rested
  std::vector<double> early_;          // awake: what its speed must not exceed, m/s
  std::vector<Vec3> position_;         // asleep: where it fell asleep, m
  std::vector<Vec3> acceleration_;     // asleep: of the fields then, m/s^2
  std::vector<std::uint8_t> isGhost_;  // asleep: it was one then
  // Scratch, by ball; of those awake alone.
  std::vector<std::uint8_t> isPressed_;
  std::vector<double> speed_;          // m/s, of those slow
  std::vector<double> ahead_;          // m, that it may get in a step
  std::vector<std::uint32_t> island_;  // union-find
  struct Rest {
    bool isLong = true;
    double now = 0;    // m/s, the fastest of the island
    double early = 0;  // m/s, likewise in the first half of its rest
    std::uint32_t group = kAwake;
  };
  std::vector<Rest> rest_;  // of the island, at its root

  std::vector<std::uint32_t> awake_;
  std::vector<std::uint32_t> slow_;  // of the last end(): all others that are awake have not rested
  std::map<std::uint32_t, Group> groups_;  // by lowest ball
  RestingBoxes boxes_;                     // of those asleep
  FieldWells wells_;                       // when those asleep were last looked at
  std::uint64_t conditions_ = 0;           // that the last step was done under
  std::optional<std::int64_t> nextStep_;
  bool needsBoxes_ = false;  // since restore()
  std::vector<std::uint32_t> woken_;
  std::vector<std::uint32_t> fallen_;
  std::vector<std::uint32_t> found_;
  std::vector<StepperMemory::Contact> returned_;  // of islands that wake
};

}  // namespace wells
