// The balls of a session: who owns each, by its record, and what its state is here. Applies what
// other peers say about balls to the world, and decides what this peer does with its own: offer,
// accept, adopt. Sends nothing and knows no clock.
//
// A ball that this peer owns has Role::Owned in the world; every other one is a ghost.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "network/drops.h"
#include "network/gathering.h"
#include "network/session_options.h"
#include "network/view_history.h"
#include "ownership/adoption.h"
#include "ownership/leases.h"
#include "ownership/records.h"

namespace wells {

/// What a message says about one ball.
struct BallNews {
  std::size_t ball = 0;
  Version version{};
  BallState state{};
};

/// An offer that must be repeated until its receiver is heard.
struct OpenOffer {
  std::size_t ball = 0;
  Version version{};
  BallState state{};    // at the start of version.step
  double nextSend = 0;  // s
};

struct BallCounts {
  std::int64_t handoversGiven = 0;
  std::int64_t handoversTaken = 0;
  std::int64_t adoptions = 0;
  double doubledBallSeconds = 0;  // simulated here and by an adopter, who won; from above
};

/// When a message came, and what its sender's silence before it means.
struct Hearing {
  double now = 0;         // s
  double apartSince = 0;  // s; the sender may have adopted our balls since then; now: it did not
  double patience = 1;    // s that an offer to others may take before it is repeated from here
};

class SharedBalls {
 public:
  /// Steps that a state may lie ahead of ours; and behind, before it is taken as if it were so old.
  static constexpr std::int64_t kMaxAhead = 120;
  static constexpr std::int64_t kMaxPredicted = 300;

  /// Ball-steps of prediction between two calls of beginTick(); states for which there is nothing
  /// left are taken as if they were of now. After a stall, or for one who joins, catching up must
  /// not become the next stall.
  static constexpr std::int64_t kPredictionBudget = 20'000;

  SharedBalls(const World& initial, Predictor predict);

  // Changes of the session as a whole.

  /// `founder` founds a generation, with the initial states, and owns everything.
  void found(World& world, const Generation& generation, const Incarnation& founder, double now);

  /// Starts over in another generation: initial states, records that know nothing.
  void enter(World& world, const Generation& generation);

  /// Gives everything up after our own loop stood still: a new incarnation knows no more than a
  /// joiner. The states stay, in case that nobody else is left to hear them from.
  void forget(World& world, const Generation& generation);

  /// Gives up acting as the owner of anything; records stay.
  void drop(World& world);

  /// What is held of each ball since enter() or forget().
  const Gathering& gathering() const { return gathering_; }

  /// While gathering: a state of every ball is held and every record names an owner.
  bool knowsAllOwners() const;

  /// Ends the gathering: all states are brought to world.step.
  void activate(World& world);

  // What others say. Only of members that are active in our generation.

  /// While gathering: keeps the newest state of each ball, and the offers, to be repeated once we
  /// are active: perhaps nobody else has heard them.
  std::optional<Drop> gather(World& world, const BallNews& news, Standing standing,
                             const Hearing& hearing);

  /// While active: an owner's state.
  std::optional<Drop> hearState(World& world, const BallNews& news, const Hearing& hearing);

  /// While active: an offer, to us (`self`) or to somebody else. Offers to others are repeated from
  /// here, too, if their receiver is not heard for a while: the one who made the offer may be gone.
  std::optional<Drop> hearOffer(World& world, const BallNews& news, const Party& self,
                                const Hearing& hearing);

  /// While gathering: an active peer's digest of a bucket. A state of the step `recent` or a later
  /// one, from an owner whose lease lasts, is recent.
  void hearDigest(const Incarnation& peer, std::size_t bucket, const BucketDigest& theirs,
                  std::int64_t recent, const Leases& leases, double now);

  /// While active: our own balls of a bucket that a peer in this phase seems not to know rightly.
  std::vector<std::uint32_t> wanted(std::size_t bucket, const BucketDigest& theirs,
                                    Phase theirPhase, const Incarnation& self) const;

  /// A tick begins.
  void beginTick() { predictionLeft_ = kPredictionBudget; }

  /// Applies what was heard early and holds at world.step. Call at every step.
  void applyDue(World& world, const Party& self);

  // What this peer does.

  /// Offers the balls for which another peer's well is nearer, by the rule. `receivers` are the
  /// peers whose wells these are.
  void offerNearer(World& world, const Party& self, std::span<const PeerWell> wells,
                   std::span<const Party> receivers, const HandoverRule& rule, double now);

  /// Adopts the balls whose owner's lease has ended long enough ago. `wells` are those of the
  /// living, ours included; lease in s.
  void adoptOrphans(World& world, const Party& self, Leases& leases,
                    std::span<const PeerWell> wells, double lease, double now);

  /// Adopts every ball whose owner is not alive, without waiting: nobody else is there.
  void adoptAll(World& world, const Party& self, const Leases& leases, double now);

  /// What `self` tells others of a bucket: active, of the balls whose owner has been known since
  /// `knownBefore` (s); syncing, of those of which it holds a state.
  BucketDigest digest(std::size_t bucket, Phase phase, double knownBefore) const;

  /// Notes that the state at world.step is published, and returns its version.
  Version publish(const World& world, std::size_t ball, const Party& self);

  /// Keeps what is shown at world.step.
  void recordView(const World& world);

  // What there is to see.

  const std::vector<Record>& records() const { return records_; }
  std::vector<OpenOffer>& openOffers() { return openOffers_; }

  /// Forgets the offers whose receiver was heard, or that something newer has overtaken.
  void closeOffers();

  /// True when every ball here has the state that its owner has published for this step.
  bool isComplete(const World& world) const;

  std::size_t ghosts() const { return ghosts_; }
  const BallCounts& counts() const { return counts_; }
  const ViewDifference& viewDifference() const { return viewDifference_; }

 private:
  std::optional<Drop> check(const World& world, const BallNews& news) const;
  void setRecord(std::size_t ball, const Record& record, double now);
  void setRole(World& world, std::size_t ball, Role role);
  void countDoubled(const World& world, const BallNews& news, const Hearing& hearing);
  /// Sets the state that holds at `step` <= world.step, brought to world.step.
  void place(World& world, std::size_t ball, const BallState& state, std::int64_t step);
  void takeBall(World& world, std::size_t ball, const Party& self);
  void adoptBall(World& world, std::size_t ball, const Party& self, double now);
  void compareWithView(const World& world, const BallNews& news, double now);

  Predictor predict_;
  Balls initial_;
  std::vector<Record> records_;
  std::vector<double> since_;  // s; when the tenure of each record began or was learned
  std::vector<HandoverWatch> watches_;
  Gathering gathering_;
  std::size_t ghosts_ = 0;
  std::map<std::pair<std::int64_t, std::size_t>, BallNews> early_;  // by (step, ball)
  std::vector<OpenOffer> openOffers_;
  std::int64_t predictionLeft_ = kPredictionBudget;
  ViewHistory views_;
  ViewDifference viewDifference_;
  BallCounts counts_;
};

}  // namespace wells
