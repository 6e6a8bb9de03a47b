// One island of many balls through a step, in substeps: the physics of advance.h, laid out for
// speed. Balls are copied into small records in the order of the island, contacts are split into
// batches that share no ball, and vector kernels solve a batch side by side, in as many threads as
// there are. The bits depend neither on the instruction set nor on the number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "contacts/contact_batches.h"
#include "contacts/crowd_kernels.h"
#include "contacts/ledger.h"
#include "contacts/near_pairs.h"
#include "contacts/path.h"
#include "contacts/spatial_order.h"
#include "state/books.h"
#include "state/stage_clock.h"
#include "state/world.h"
#include "threads/thread_pool.h"
#include "world/contact_memory.h"

namespace wells {

/// An island, and what its step depends on.
struct CrowdInput {
  const Settings& settings;
  const PathModel& model;
  std::span<const std::uint32_t> island;
  std::span<const BallPair> pairs;  // that may touch within the step, those with the arena last
  std::span<const std::uint8_t> isLeaning;  // by ball of the world; ghosts that drift
  const ContactMemory& memory;
};

class Crowd {
 public:
  /// Advances the balls of the island by settings.dt. Books it unless `books` is null.
  void step(const CrowdInput& in, Balls& balls, ThreadPool& pool, Books* books);

  /// Adds the contacts that lasted to the end of the last step.
  void keep(ContactMemory& memory) const;

  /// Null: none.
  void setClock(StageClock* clock) { clock_ = clock; }

 private:
  /// Those blocks of a worker that it has filled with a batch.
  struct Part {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  /// Batches between which no thread waits: those of tiles, each tile one thread's; one that all
  /// threads share; or some that are not worth it, which the first does.
  enum class Sharing : std::uint8_t { Tiles, Batch, Nothing };
  struct Group {
    std::size_t first;
    std::size_t last;
    Sharing sharing;
  };
  /// What a thread has to itself; on cache lines of its own.
  struct alignas(64) Worker {
    CrowdSubstep substep;                 // what it found
    double changed[2] = {0, 0};           // m/s, by parity of the pass
    std::size_t used = 0;                 // of the blocks
    std::vector<ContactBlock> blocks;     // with room for more
    std::vector<ContactFlight> flights;   // of the same contacts
    std::vector<std::uint32_t> touching;  // scratch
    std::span<const std::uint32_t> late;  // of these, far pairs
  };

  // Exchange with the world (crowd_exchange.cpp).
  void gather(std::span<const std::uint32_t> ids, const Balls& balls, ThreadPool& pool);
  void findContacts(const CrowdInput& in, ThreadPool& pool);
  void makeRoomForLasting();
  void startFrom(const ContactMemory& memory, ThreadPool& pool);
  void scatter(std::span<const std::uint32_t> ids, Balls& balls) const;

  void planGroups();
  CrowdArrays arraysOf(std::size_t thread);
  // By all threads.
  void runSubstep(const CrowdInput& in, double start, ThreadPool& pool);
  void fly(const CrowdInput& in, double start, IndexRange range);
  /// Those of pairs first .. last - 1 that touch, until the thread asks again.
  std::span<const std::uint32_t> touching(std::size_t thread, PartnerKind partner,
                                          const IndexPair* pairs, std::size_t first,
                                          std::size_t last);
  void findLate(std::size_t thread, Barrier& barrier);
  void addLate();
  void prepare(std::size_t thread, Barrier& barrier);
  void solve(const Settings& settings, std::size_t thread, Barrier& barrier);
  void shift(std::size_t thread, Barrier& barrier);
  void pushOut(std::size_t thread, Barrier& barrier);
  void keepInArena();
  bool takesPart(std::size_t thread, Sharing sharing, const ContactBatch& batch) const;
  /// Calls action(number of the batch, its partner, part) for each part that is the thread's.
  template <class Action>
  void forEachPart(std::size_t thread, Barrier& barrier, Action action);
  std::span<ContactBlock> blocksOf(std::size_t thread, const Part& part) {
    return std::span(workers_[thread].blocks).subspan(part.first, part.count);
  }
  /// Calls action(partner, block, flight) for all that the last substep prepared.
  template <class Action>
  void forEachBlock(Action action) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Worker& worker = workers_[p % threads_];
      for (std::size_t n = parts_[p].first; n < parts_[p].first + parts_[p].count; ++n)
        action(batches_.batches()[p / threads_].partner, worker.blocks[n], worker.flights[n]);
    }
  }
  CrowdSubstep substepOfAll() const;

  // Booking (crowd_books.cpp), from states between the parts of a substep; `balls` get these.
  struct Booking {
    double kineticEnergy = 0;  // J
    Placement placement;
  };
  void runBookedSubstep(const CrowdInput& in, double start, ThreadPool& pool, Balls& balls,
                        Books& books);
  void bookFlights(const CrowdInput& in, double start, Balls& balls, Books& books) const;
  Booking bookingOf(const PathModel& model, double time, Balls& balls) const;
  /// What the impulses did to momentum, and the work of the normal ones.
  Books booksOfImpulses(const PathModel& model, const Balls& balls);
  void bookSubstep(const Booking& flown, const Booking& solved, const Booking& shifted,
                   const Booking& pushed, Books impulses, Books& books) const;

  StageClock* clock_ = nullptr;
  SpatialOrder order_;
  std::span<const std::uint32_t> island_;  // in that order
  CrowdRules rules_;
  bool isLastSubstep_ = false;
  std::size_t threads_ = 1;
  std::vector<std::uint32_t> placeOf_;  // by ball of the world, in the island
  // By ball of the island, then the idle ones.
  std::vector<Place> place_;
  std::vector<Momentum> momentum_;
  std::vector<Gained> gained_;
  NearPairs pairs_;
  // By pair in the order of the batches; idle ones; late ones.
  ContactBatches batches_;
  std::vector<LastingImpulse> lasting_;
  std::vector<std::uint32_t> touchedIn_;
  // By batch.
  std::vector<Group> groups_;
  std::vector<Part> parts_;      // of each batch, by thread
  std::vector<Worker> workers_;  // by thread
};

}  // namespace wells
