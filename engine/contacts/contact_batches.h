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
  /// Splits the pairs of the balls `balls`: first those between balls, by (a, b), then those with
  /// the arena. place[id] is the place of ball id in `balls`, and the order of the pairs of a batch
  /// is that of `balls`.
  void split(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
             std::span<const std::uint32_t> place);

  std::span<const ContactBatch> batches() const { return batches_; }
  /// In the order of the batches. Indices of balls; b of a contact with the arena is one behind all
  /// balls.
  std::span<const IndexPair> pairs() const { return pairs_; }
  /// By pair given, its place in pairs().
  std::span<const std::uint32_t> slots() const { return slots_; }

 private:
  void orderPairs(std::span<const BallPair> pairs, std::span<const std::uint32_t> balls,
                  std::span<const std::uint32_t> place);

  std::vector<ContactBatch> batches_;
  std::vector<IndexPair> pairs_;
  std::vector<std::uint32_t> slots_;
  // Scratch.
  std::vector<std::uint32_t> firstOf_;  // by ball, of its pairs as a
  std::vector<std::uint32_t> order_;    // of the pairs given
  std::vector<std::uint64_t> used_;     // by ball, colours
  std::vector<std::uint8_t> colour_;    // by pair given
  std::vector<std::uint32_t> next_;     // by colour
};

}  // namespace wells
