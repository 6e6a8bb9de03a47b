// What a peer knows about the ownership of one ball, and every way in which that may change: pure
// functions from a record to the next one. They know no clock, no network and no ball's motion.
//
// "A peer that learns a greater version takes it at once; it never goes back": each function here
// returns a record of at least the version that it was given.
#pragma once

#include <optional>

#include "ownership/version.h"

namespace wells {

/// Naming the next owner is giving up. From the offer until the named owner is heard publishing,
/// nobody may be acting as owner; the offer is repeated until then.
enum class Standing : std::uint8_t {
  Named,  // the version's owner has been named; we have not heard it publish
  Heard,  // the version's owner has published, or is us
};

struct Record {
  Version version{};
  Standing standing = Standing::Named;

  bool operator==(const Record&) const = default;
};

/// True when `self` acts as the owner.
inline bool owns(const Record& record, const Incarnation& self) {
  return record.version.owner == self && record.standing == Standing::Heard;
}

/// The founder of a generation owns every ball.
Record found(const Generation& generation, const Incarnation& founder, std::int64_t step);

/// Of a peer that knows the generation and no more: less than every record of an owner.
Record unknown(const Generation& generation);

/// An owner's state of `version` was heard. Nothing when we know as much already.
std::optional<Record> learnState(const Record& record, const Version& version);

/// An offer of `version` was heard, to whomever. Nothing when we know as much already.
std::optional<Record> learnOffer(const Record& record, const Version& version);

/// `self`, which the record names, takes the ball. Requires record.version.owner == self: an offer
/// to another incarnation of the same peer must not be accepted.
Record accept(const Record& record, const Incarnation& self);

/// The owner `self` names `receiver` as the next one, with the state of `step`, and stops owning.
/// Requires owns(record, self).
Record offer(const Record& record, const Incarnation& self, const Incarnation& receiver,
             std::int64_t step);

/// `self` was offered a ball that it does not want and offers it back to `giver`; there is no other
/// withdrawal. Requires as accept.
Record decline(const Record& record, const Incarnation& self, const Incarnation& giver,
               std::int64_t step);

/// `self` takes the ball of an owner that is gone, with the state that it predicted for `step`.
Record adopt(const Record& record, const Incarnation& self, std::int64_t step);

/// The owner publishes the state of `step`. Requires owns(record, self) for some self and a step
/// not before the record's.
Record publish(const Record& record, std::int64_t step);

/// False for a version that no peer can have made: an adopter in the first term, none in a later
/// one, or a term's first owner who is not its adopter.
bool isPossible(const Version& version);

/// True when `version` names another owner for the tenure that the record knows, or knew while it
/// was named: a forgery, or a peer that lost its memory and kept its incarnation.
bool contradicts(const Record& record, const Version& version);

}  // namespace wells
