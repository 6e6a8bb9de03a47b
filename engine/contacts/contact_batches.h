// Contacts of a crowd in batches that share no ball, so that those of one batch can be solved side
// by side. The balls are divided into tiles, short stretches of their order in space: contacts
// within a tile are done tile by tile, while its balls are in the cache, then those between tiles,
// then those with the arena, whose word is final. Within each: greedy edge colouring, with a bit
// mask of used colours for each ball.
#pragma once

#include <span>
#include <vector>

#include "broadphase/ball_pair.h"
#include "contacts/crowd_kernels.h"

namespace wells {

inline constexpr std::uint32_t kTileBalls = 512;
inline constexpr std::uint32_t kNoTile = 0xffffffff;

struct ContactBatch {
  PartnerKind partner;
  std::uint32_t tile;   // that has all its balls, or kNoTile
  std::uint32_t first;  // of pairs()
  std::uint32_t last;   // behind its last
};

class ContactBatches {
 public:
  /// Splits the pairs of the balls `balls`: given are first those between balls, by (a, b), then
  /// those with the arena. place[id] is the place of ball id in `balls`, and the order of the pairs
  /// of a batch is that of `balls`.
  void split(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
             std::span<const std::uint32_t> place);

  /// Those of tiles first, tile by tile.
  std::span<const ContactBatch> batches() const { return batches_; }
  std::uint32_t tiles() const { return tiles_; }
  /// In the order of the batches. Indices of balls; b of a contact with the arena is one behind all
  /// balls.
  std::span<const IndexPair> pairs() const { return pairs_; }
  /// By pair given, its place in pairs().
  std::span<const std::uint32_t> slots() const { return slots_; }

 private:
  void orderPairs(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                  std::span<const std::uint32_t> place);
  void colour();
  void listBatches();

  std::uint32_t tiles_ = 0;
  std::vector<ContactBatch> batches_;
  std::vector<IndexPair> pairs_;
  std::vector<std::uint32_t> slots_;
  // Scratch.
  struct First {
    std::uint32_t ball;
    std::uint32_t arena;
  };
  struct Ordered {
    IndexPair balls;
    std::uint32_t given;  // its place among the pairs given
    std::uint32_t list;   // which batch, if empty ones are counted
  };
  /// Colours that a ball has in contacts within its tile, and in others.
  struct Used {
    std::uint64_t within = 0;
    std::uint64_t between = 0;
  };
  std::vector<First> firstOf_;       // by ball, of its pairs as a, with each kind of partner
  std::vector<Ordered> ordered_;     // in the order of the balls
  std::vector<Used> used_;           // by ball
  std::vector<std::uint32_t> next_;  // by such a batch
};

}  // namespace wells
