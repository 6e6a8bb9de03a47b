// What the search explores: the transition functions of ownership/records.h, and how a session uses
// them. The defaults are the real ones; tests put defects in their place and expect to be told.
#pragma once

#include <optional>

#include "ownership/records.h"

namespace wells {

struct Transitions {
  bool (*owns)(const Record&, const Incarnation&) = wells::owns;
  Record (*found)(const Generation&, const Incarnation&, std::int64_t) = wells::found;
  Record (*unknown)(const Generation&) = wells::unknown;
  std::optional<Record> (*learnState)(const Record&, const Version&) = wells::learnState;
  std::optional<Record> (*learnOffer)(const Record&, const Version&) = wells::learnOffer;
  bool (*mayTake)(const Record&, const Party&) = wells::mayTake;
  Record (*take)(const Record&, const Party&) = wells::take;
  bool (*mayOffer)(const Record&, const Party&, const Party&) = wells::mayOffer;
  Record (*offer)(const Record&, const Party&, const Party&, std::int64_t) = wells::offer;
  bool (*mayAdopt)(const Record&, const Party&, Life) = wells::mayAdopt;
  Record (*adopt)(const Record&, const Party&, std::int64_t) = wells::adopt;
  bool (*mayPublish)(const Record&, const Party&) = wells::mayPublish;
  Record (*publish)(const Record&, const Party&, std::int64_t) = wells::publish;
  bool (*isPossible)(const Version&) = wells::isPossible;
  bool (*contradicts)(const Record&, const Version&) = wells::contradicts;

  /// The rules know no withdrawal. A test may plant one: what becomes of an open offer at the one
  /// who made or heard it.
  std::optional<Record> (*withdraw)(const Record&, const Party&) = nullptr;
};

/// What a session does that is not a transition of a record.
struct Conduct {
  enum class Numbers : std::uint8_t { Fresh, Reused } numbers = Numbers::Fresh;
  enum class Lease : std::uint8_t { OfIncarnation, OfPeer } lease = Lease::OfIncarnation;
  enum class Offers : std::uint8_t { Repeated, SentOnce } offers = Offers::Repeated;
  /// Whether offers that were heard while syncing are repeated once active.
  enum class Gathering : std::uint8_t {
    KeepsOffers,
    ForgetsOffers
  } gathering = Gathering::KeepsOffers;
  /// How long one that syncs waits for its digests to agree with those of everybody who is active.
  enum class Agreement : std::uint8_t { ForAWhile, ForEver } agreement = Agreement::ForAWhile;
  enum class Activation : std::uint8_t {
    WithAllStates,
    Blind
  } activation = Activation::WithAllStates;
};

struct Protocol {
  Transitions transitions{};
  Conduct conduct{};
};

}  // namespace wells
