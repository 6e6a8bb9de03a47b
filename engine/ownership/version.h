// The version of a ball's record: who has owned it how often, in one total order that every peer
// computes the same way. Plain data; how versions come about is in records.h.
#pragma once

#include <compare>
#include <cstdint>

#include "math/ids.h"

namespace wells {

/// One start of a peer. Numbers are random and never used again, so that a restarted peer is not
/// taken for the one that crashed.
struct Incarnation {
  PeerId peer = kNobody;
  std::int64_t number = 0;  // never 0 for a peer that exists

  auto operator<=>(const Incarnation&) const = default;
};

/// Which session: who founded it when, and how often it has been reset since.
struct Generation {
  std::int64_t resets = 0;
  std::int64_t foundedUs = 0;  // us since 1970, founder's wall clock; 0: no generation at all
  std::int64_t nonce = 0;      // random, tells two foundings in the same microsecond apart

  bool exists() const { return foundedUs != 0; }

  bool operator==(const Generation&) const = default;

  /// No generation is less than any; then more resets win, then the *earlier* founding, then the
  /// nonce.
  std::strong_ordering operator<=>(const Generation& other) const {
    if (exists() != other.exists()) return exists() <=> other.exists();
    if (const auto order = resets <=> other.resets; order != 0) return order;
    if (const auto order = other.foundedUs <=> foundedUs; order != 0) return order;
    return nonce <=> other.nonce;
  }
};

/// Compared member by member in this order. At most one owner ever holds a ball under the same
/// (generation, term, adopter, epoch); within such a tenure only the step rises.
struct Version {
  Generation generation{};
  std::int64_t term = 0;   // rises by one at each adoption
  Incarnation adopter{};   // who began the term; nobody in the first one
  std::int64_t epoch = 0;  // rises by one at each hand-over of the term
  Incarnation owner{};
  std::int64_t step = 0;  // at whose start the state that goes with this version holds

  auto operator<=>(const Version&) const = default;
};

/// True when both belong to the same tenure of one owner, except perhaps for who that owner is:
/// two owners here would break the promise above.
inline bool sameTenure(const Version& a, const Version& b) {
  return a.generation == b.generation && a.term == b.term && a.adopter == b.adopter &&
         a.epoch == b.epoch;
}

}  // namespace wells
