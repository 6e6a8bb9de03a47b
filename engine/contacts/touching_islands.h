// Contacts that act in a substep, in groups that hang together by the balls they share: what the
// contacts of one group do does not depend on another's. Ground and wall do not tie balls together.
// (world/islands.h groups all pairs that may meet within a step.)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contacts/contact.h"

namespace wells {

class TouchingIslands {
 public:
  /// Groups the contacts of both lists that act. ballCount is that of the world.
  void find(std::span<Contact> balls, std::span<Contact> arena, std::size_t ballCount);

  std::size_t count() const { return start_.empty() ? 0 : start_.size() - 1; }

  /// Of all islands, one after the other.
  std::span<Contact* const> contacts() const { return contacts_; }

  /// Those between balls first, each in the order of its list. Islands are in order of their first
  /// contact.
  std::span<Contact* const> contacts(std::size_t island) const {
    return std::span(contacts_).subspan(start_[island], start_[island + 1] - start_[island]);
  }

 private:
  std::vector<std::uint32_t> parent_;    // by ball, union-find; only those of contacts are valid
  std::vector<std::uint32_t> islandOf_;  // by ball, valid at roots
  std::vector<std::uint32_t> start_, next_;
  std::vector<Contact*> acting_;  // in the order of the lists
  std::vector<Contact*> contacts_;
};

}  // namespace wells
