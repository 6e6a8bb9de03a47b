// One island of many balls through a step, in substeps: the physics of advance.h, laid out for
// speed. Balls are copied into small records in the order of the island, contacts are split into
// batches that share no ball, and vector kernels solve a batch side by side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "contacts/contact_batches.h"
#include "contacts/crowd_kernels.h"
#include "contacts/ledger.h"
#include "contacts/path.h"
#include "state/books.h"
#include "state/stage_clock.h"
#include "state/world.h"
#include "world/contact_memory.h"

namespace wells {

class Crowd {
 public:
  /// Advances the balls of the island by settings.dt. `pairs` (all that may touch within the step,
  /// those with the arena last) start from the impulses of `memory`. Ghosts with isLeaning[ball]
  /// move on at their velocity. Books it unless `books` is null.
  void step(const Settings& settings, const PathModel& model, std::span<const std::uint32_t> island,
            std::span<const BallPair> pairs, std::span<const std::uint8_t> isLeaning,
            const ContactMemory& memory, Balls& balls, Books* books);

  /// Null: none.
  void setClock(StageClock* clock) { clock_ = clock; }

  /// Adds the contacts that lasted to the end of the last step.
  void keep(std::span<const BallPair> pairs, ContactMemory& memory) const;

 private:
  void gather(const Settings& settings, std::span<const BallPair> pairs,
              const ContactMemory& memory, const Balls& balls);
  void fly(const PathModel& model, double start, std::span<const std::uint8_t> isLeaning);
  CrowdSubstep prepare();
  void solve(const Settings& settings, const CrowdSubstep& substep);
  void shift();
  void pushOut();
  void scatter(Balls& balls) const;
  /// Calls action(partner, blocks of the batch, their flights).
  template <class Action>
  void forEachBatch(Action action) {
    const auto batches = batches_.batches();
    for (std::size_t n = 0; n < batches.size(); ++n) {
      const Blocks& blocks = blocksOf_[n];
      action(batches[n].partner, std::span(blocks_).subspan(blocks.first, blocks.count),
             flights_.data() + blocks.first);
    }
  }

  // Booking (crowd_books.cpp), from states between the parts of a substep; `balls` get these.
  struct Booking {
    double kineticEnergy = 0;  // J
    Placement placement;
  };
  void bookFlights(const PathModel& model, double start, std::span<const std::uint8_t> isLeaning,
                   Balls& balls, Books& books) const;
  Booking bookingOf(const PathModel& model, double time, Balls& balls) const;
  /// What the impulses did to momentum, and the work of the normal ones.
  Books booksOfImpulses(const PathModel& model, const Balls& balls);
  void bookSubstep(const Booking& flown, const Booking& solved, const Booking& shifted,
                   const Booking& pushed, Books impulses, Books& books) const;

  StageClock* clock_ = nullptr;
  std::span<const std::uint32_t> island_;
  CrowdRules rules_;
  CrowdArrays arrays_;
  std::vector<std::uint32_t> placeOf_;  // by ball of the world, in the island
  // By ball of the island, and two more (see CrowdArrays).
  std::vector<Place> place_;
  std::vector<Momentum> momentum_;
  std::vector<Flown> flown_;
  std::vector<Vec3> position_, velocity_;  // as flights take them
  std::vector<std::uint32_t> all_;
  // By pair.
  ContactBatches batches_;
  std::vector<LastingImpulse> lasting_;
  std::vector<std::uint32_t> touchedIn_;
  std::vector<std::uint32_t> touching_;
  // By batch, then as many as touch.
  struct Blocks {
    std::size_t first;
    std::size_t count;
  };
  std::vector<Blocks> blocksOf_;
  std::vector<ContactBlock> blocks_;
  std::vector<ContactFlight> flights_;
};

}  // namespace wells
