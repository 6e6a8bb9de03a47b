// What a peer knows about the ownership of one ball, and every way in which that may change: pure
// functions from a record to the next one. They know no clock, no network and no ball's motion.
//
// "A peer that learns a greater version takes it at once; it never goes back": each function here
// returns a record of at least the version that it was given.
#pragma once

#include <optional>

#include "ownership/phase.h"
#include "ownership/version.h"

namespace wells {

/// A peer as far as it matters for what it may do with a record.
struct Party {
  Incarnation self{};
  Phase phase = Phase::Joining;
};

/// What is known of the peer that a ball may be offered to, or adopted from.
enum class Life : std::uint8_t { Lasts, Ended };

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

/// True when `party` may take the ball now: the record names this very incarnation, which is active
/// and has not taken the ball yet. An offer to another incarnation of the same peer is not for it.
bool mayTake(const Record& record, const Party& party);

/// Takes the ball. Requires mayTake.
Record take(const Record& record, const Party& party);

/// True when `party` may offer the ball to `receiver`, another peer in this phase.
bool mayOffer(const Record& record, const Party& party, const Party& receiver);

/// The owner names `receiver` as the next one, with the state of `step`, and stops owning. Requires
/// mayOffer. There is no withdrawal: a receiver that does not want the ball offers it back.
Record offer(const Record& record, const Party& party, const Party& receiver, std::int64_t step);

/// True when `party` may adopt the ball from an owner of whom `owner` is known.
bool mayAdopt(const Record& record, const Party& party, Life owner);

/// `party` takes the ball of an owner that is gone, with the state that it predicted for `step`.
/// Requires mayAdopt.
Record adopt(const Record& record, const Party& party, std::int64_t step);

/// True when `party` may publish the ball.
bool mayPublish(const Record& record, const Party& party);

/// The owner publishes the state of `step`, which is not before the record's. Requires mayPublish.
Record publish(const Record& record, const Party& party, std::int64_t step);

/// False for a version that no peer can have made: an adopter in the first term, none in a later
/// one, or a term's first owner who is not its adopter.
bool isPossible(const Version& version);

/// True when `version` names another owner for the tenure that the record knows, or knew while it
/// was named: a forgery, or a peer that lost its memory and kept its incarnation.
bool contradicts(const Record& record, const Version& version);

}  // namespace wells
