// The contacts that are possible within a step: the broadphase's pairs, narrowed by how far each
// ball may move, in an order that does not depend on the broadphase's history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "contacts/contact.h"
#include "state/world.h"

namespace wells {

class Candidates {
 public:
  /// reach[i] (m) bounds how far ball i moves in the step; NaN: the ball is in no pair.
  void find(const World& world, std::span<const double> reach);

  /// Of the last find(), by (a, b).
  std::vector<Contact>& balls() { return balls_; }
  std::vector<Contact>& arena() { return arena_; }

  /// Pairs of the broadphase.
  std::int64_t pairs() const;

  /// By ball, 1 for ghosts that touch ghosts: a contact between other peers' balls is theirs to
  /// compute. Here such balls only stop falling, because what holds them is not known.
  std::span<const std::uint8_t> isLeaning() const { return isLeaning_; }

 private:
  void findBalls(const World& world, std::span<const double> reach);
  void findArena(const World& world, std::span<const double> reach);

  Broadphase broadphase_;
  std::vector<Contact> balls_;
  std::vector<Contact> arena_;
  std::vector<std::uint64_t> sorted_;  // a in the upper half, b in the lower
  std::vector<std::uint8_t> isLeaning_;
};

}  // namespace wells
