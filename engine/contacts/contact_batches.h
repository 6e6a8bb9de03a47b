// Contacts of a crowd in batches that share no ball, so that those of one batch can be solved side
// by side. The balls are divided into tiles, short stretches of their order in space: contacts
// within a tile are done tile by tile, while its balls are in the cache, then those between tiles,
// then those with the arena, whose word is final. Within each: greedy edge colouring, with a bit
// mask of used colours for each ball.
//
// Pairs that will hardly touch (far ones) are in no batch. Those of them that do touch, found
// substep by substep, are coloured then: late ones, done before those with the arena.
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
  /// Orders the pairs of the balls `balls`, for split(): given are first those between balls, by
  /// (a, b), then those with the arena. place[id] is the place of ball id in `balls`, and the order
  /// of the pairs of a batch is that of `balls`.
  void order(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
             std::span<const std::uint32_t> place, ThreadPool& pool);
  /// Those between balls, in the order of `balls`; indices of balls.
  std::span<const IndexPair> ordered() const { return ordered_; }

  /// Splits into batches the pairs with isNear (1 or 0, by pair of ordered()) and those with the
  /// arena.
  void split(std::span<const std::uint8_t> isNear, ThreadPool& pool);

  /// For the substep at hand, batches of those far pairs (numbers in pairs()) that touch.
  void setLate(std::span<const std::uint32_t> touching);

  /// Those of tiles first, tile by tile.
  std::span<const ContactBatch> batches() const { return batches_; }
  std::uint32_t tiles() const { return tiles_; }
  /// In the order of the batches, then those that are far. Indices of balls; b of a contact with
  /// the arena is one behind all balls.
  std::span<const IndexPair> pairs() const { return pairs_; }
  /// Of pairs(), the first that is far.
  std::uint32_t firstFar() const { return firstFar_; }
  /// In the order of late batches; numbers in pairs().
  std::span<const std::uint32_t> late() const { return late_; }
  static constexpr std::uint32_t kNoPair = 0xffffffff;
  /// The number in pairs() of the pair of ball a (an index) with another, or with kGround or kWall;
  /// kNoPair if there is none.
  std::uint32_t find(std::uint32_t a, std::uint32_t partner) const;

 private:
  IndexRange ordersOf(std::uint32_t tile) const;
  void colourTile(std::uint32_t tile, std::span<const std::uint8_t> isNear);
  void colourBetween();
  void placeTile(std::uint32_t tile);
  void placeOthers();
  void place(std::uint32_t& slot, const IndexPair& pair);
  template <class Action>
  void forEachBetween(Action action) const;
  void listBatches();

  std::uint32_t tiles_ = 0;
  std::uint32_t firstFar_ = 0;
  std::vector<ContactBatch> batches_;
  std::vector<IndexPair> pairs_;
  std::vector<std::uint32_t> late_;
  struct Run {
    std::uint32_t given = 0;  // the first of the pairs given
    std::uint32_t count = 0;
    std::uint32_t first = 0;  // of ordered_
  };
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
  std::vector<Run> runOf_;          // by ball, its pairs as a
  std::vector<IndexPair> ordered_;  // those between balls
  std::vector<ArenaPair> ofArena_;  // by ball
  // By pair of ordered_, then by pair of ofArena_: which batch, if empty ones are counted; then the
  // number in pairs().
  std::vector<std::uint32_t> slot_;
  // Of each tile, from where its pairs begin in ordered_: those that are near, but not with a ball
  // of the tile, or for which no colour was left. Numbers in ordered_.
  std::vector<std::uint32_t> between_;
  std::vector<std::uint32_t> betweenOf_;   // by tile, how many
  std::vector<std::uint32_t> lateColour_;  // by pair that touches
  std::vector<Used> used_;                 // by ball
  std::vector<std::uint32_t> next_;        // by such a batch
  std::vector<ContactBatch> arenaBatches_;
  std::size_t ballBatches_ = 0;  // of batches_, those that stay for the whole step
};

}  // namespace wells
