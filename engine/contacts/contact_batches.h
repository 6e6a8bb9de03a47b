// Contacts of a crowd in batches that share no ball, so that those of one batch can be solved side
// by side: greedy edge colouring in the order of the pairs, a bit mask of used colours for each
// ball. A batch holds contacts with one kind of partner; those with the arena come last, because
// its word is final.
#pragma once

#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "contacts/crowd_kernels.h"

namespace wells {

struct ContactBatch {
  PartnerKind partner;
  std::uint32_t first;  // of pairs()
  std::uint32_t last;   // behind its last
};

class ContactBatches {
 public:
  /// Splits the pairs of the balls `balls` (rising ids), those with ground and wall last.
  /// place[id] is the place of ball id in `balls`.
  void split(std::span<const BallPair> pairs, std::span<const std::uint32_t> place,
             std::size_t ballCount);

  std::span<const ContactBatch> batches() const { return batches_; }
  /// Indices of balls; b of a contact with the arena is one behind all balls.
  std::span<const IndexPair> pairs() const { return pairs_; }
  /// By pair of pairs(), its place among those given.
  std::span<const std::uint32_t> source() const { return source_; }

 private:
  std::vector<ContactBatch> batches_;
  std::vector<IndexPair> pairs_;
  std::vector<std::uint32_t> source_;
  // Scratch.
  std::vector<std::uint64_t> used_;   // by ball, colours
  std::vector<std::uint8_t> colour_;  // by pair given
  std::vector<std::uint32_t> next_;   // by colour
};

}  // namespace wells
