// Contacts of a crowd in batches that share no ball, so that those of one batch can be solved side
// by side. The balls are divided into tiles, short stretches of their order in space: contacts
// within a tile are done tile by tile, while its balls are in the cache, then those between tiles,
// then those with the arena, whose word is final. Within each: greedy edge colouring, with a bit
// mask of used colours for each ball.
//
// Pairs that will hardly touch are in no batch. Those of them that do touch, found in some substep,
// are late: they are coloured substep by substep, and done before those with the arena.
#pragma once

#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "contacts/crowd_kernels.h"
#include "threads/thread_pool.h"

namespace wells {

inline constexpr std::uint32_t kTileBalls = 512;
inline constexpr std::uint32_t kNoTile = 0xffffffff;

struct ContactBatch {
  enum class Of : std::uint8_t { Pairs, Late };
  PartnerKind partner;
  Of of;                // what first and last count
  std::uint32_t tile;   // that has all its balls, or kNoTile
  std::uint32_t first;  // of pairs() or late()
  std::uint32_t last;   // behind its last
};

class ContactBatches {
 public:
  /// Splits pairs of a crowd: `near` (to be kept until the next split) and `arena`, those of its
  /// balls with ground and wall (in any order). place[id] is the place of ball id in the crowd.
  /// Behind its pairs come `idle` numbers that are of none.
  void split(const PairsByBall& near, std::span<const BallPair> arena,
             std::span<const std::uint32_t> place, std::size_t idle, ThreadPool& pool);

  /// Adds a pair that is late for the batches; it is in one only if setLate() has it.
  void add(const IndexPair& late) { pairs_.push_back(late); }
  /// For the substep at hand, batches of those late pairs (numbers in pairs()) that touch.
  void setLate(std::span<const std::uint32_t> touching);

  /// Those of tiles first, tile by tile.
  std::span<const ContactBatch> batches() const { return batches_; }
  std::uint32_t tiles() const { return tiles_; }
  /// In the order of the batches; idle numbers; those added. Indices of balls; b of a contact with
  /// the arena is one behind all balls.
  std::span<const IndexPair> pairs() const { return pairs_; }
  std::uint32_t firstIdle() const { return firstIdle_; }
  /// The first that was added, or would be.
  std::uint32_t firstLate() const { return firstLate_; }
  /// In the order of late batches; numbers in pairs().
  std::span<const std::uint32_t> late() const { return late_; }
  static constexpr std::uint32_t kNoPair = 0xffffffff;
  /// The number in pairs() of the near pair of ball a (an index) with another, or with kGround or
  /// kWall; kNoPair if there is none.
  std::uint32_t find(std::uint32_t a, std::uint32_t partner) const;

 private:
  void listArena(std::span<const BallPair> arena, std::span<const std::uint32_t> place);
  IndexRange pairsOf(std::uint32_t tile) const;
  void colourTile(std::uint32_t tile);
  void colourBetween();
  void placeTile(std::uint32_t tile);
  void placeOthers();
  void place(std::uint32_t& slot, const IndexPair& pair);
  template <class Action>
  void forEachBetween(Action action) const;
  void listBatches();

  std::uint32_t tiles_ = 0;
  std::uint32_t firstIdle_ = 0;
  std::uint32_t firstLate_ = 0;
  std::vector<ContactBatch> batches_;
  std::vector<IndexPair> pairs_;
  std::vector<std::uint32_t> late_;
  struct ArenaPair {
    std::uint32_t a;
    std::uint32_t partner;
  };
  /// Colours that a ball has in contacts within its tile, and in others.
  struct Used {
    std::uint64_t within = 0;
    std::uint64_t between = 0;
  };
  std::uint32_t balls_ = 0;
  PairsByBall near_;
  std::vector<ArenaPair> ofArena_;       // by ball
  std::vector<std::uint8_t> withArena_;  // by ball, bits
  // By pair of near_, then by pair of ofArena_: which batch, if empty ones are counted; then the
  // number in pairs().
  std::vector<std::uint32_t> slot_;
  // Of each tile, from where its pairs begin in near_: those that are not with a ball of the tile,
  // or for which no colour was left. Numbers in near_.
  std::vector<std::uint32_t> between_;
  std::vector<std::uint32_t> betweenOf_;   // by tile, how many
  std::vector<Used> used_;                 // by ball
  std::vector<std::uint32_t> next_;        // by such a batch
  std::vector<std::uint32_t> lateColour_;  // by pair that touches
  std::vector<ContactBatch> arenaBatches_;
  std::size_t ballBatches_ = 0;  // of batches_, those that stay for the whole step
};

}  // namespace wells
