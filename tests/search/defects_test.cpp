// The search finds what it is for: each defect, put in the place of a real rule, breaks a promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "search/search.h"

namespace wells {
namespace {

const Limits kLimits{.balls = 1, .epochs = 3, .terms = 2, .suspicions = 1};

Limits safety() {
  Limits limits = kLimits;
  limits.suspicions = 2;
  limits.promises = Promises::Safety;
  return limits;
}

Result search(const Protocol& protocol, const Limits& limits = kLimits) {
  return Search(limits, protocol).run();
}

Protocol with(const Transitions& transitions) {
  return {.transitions = transitions};
}

Protocol with(const Conduct& conduct) {
  return {.conduct = conduct};
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

/// The violation must be one of these.
void expectFound(const Result& result, std::initializer_list<std::string_view> violations) {
  EXPECT_EQ(name(result.outcome), "violated");
  EXPECT_TRUE(std::ranges::any_of(
      violations,
      [&](std::string_view violation) { return contains(result.violation, violation); }))
      << result.violation << "\n"
      << result.trace;
  EXPECT_TRUE(contains(result.trace, "1. P")) << "no trace";
}

TEST(Defects, AWithdrawalWithTwoEpochsMoreGivesTwoOwners) {
  const auto withdraw = [](const Record& record, const Party& party) -> std::optional<Record> {
    if (record.version.owner.peer == party.self.peer) return std::nullopt;
    Record next{record.version, Standing::Heard};
    ++next.version.epoch;
    next.version.owner = party.self;
    return next;
  };
  expectFound(search(with({.withdraw = withdraw}), safety()),
              {"a tenure has two owners", "two peers act as owners in one term"});
}

TEST(Defects, AnIncarnationThatIsUsedAgainGivesTwoOwners) {
  expectFound(search(with({.numbers = Conduct::Numbers::Reused}), safety()),
              {"two peers act as owners in one term"});
}

TEST(Defects, AnOfferTakenByAnotherIncarnation) {
  const auto mayTake = [](const Record& record, const Party& party) {
    return party.phase == Phase::Active && record.version.owner.peer == party.self.peer &&
           record.standing == Standing::Named;
  };
  const auto take = [](const Record& record, const Party&) {
    return Record{record.version, Standing::Heard};
  };
  expectFound(search(with({.mayTake = mayTake, .take = take})),
              {"who has taken the ball does not own it"});
}

TEST(Defects, AdoptionWithoutANewTerm) {
  const auto adopt = [](const Record& record, const Party& party, std::int64_t step) {
    Record next{record.version, Standing::Heard};
    ++next.version.epoch;
    next.version.owner = party.self;
    next.version.step = step;
    return next;
  };
  Limits limits = safety();
  limits.suspicions = 0;
  expectFound(search(with({.adopt = adopt}), limits),
              {"a tenure has two owners", "two peers act as owners in one term"});
}

TEST(Defects, AdoptionByAnotherThanTheAdopterOfItsTerm) {
  const auto adopt = [](const Record& record, const Party& party, std::int64_t step) {
    Record next = wells::adopt(record, party, step);
    next.version.adopter = {PeerId{1}, 8};  // the same for everybody
    return next;
  };
  expectFound(search(with({.adopt = adopt}), safety()),
              {"a tenure has two owners", "a version that nobody can have made",
               "an honest message is refused"});
}

TEST(Defects, AdoptionFromTheLiving) {
  const auto mayAdopt = [](const Record& record, const Party& party, Life) {
    return party.phase == Phase::Active && record.version.owner != party.self;
  };
  expectFound(search(with({.mayAdopt = mayAdopt}), safety()),
              {"two peers act as owners though nothing has failed"});
}

TEST(Defects, AnOfferWithoutANewEpoch) {
  const auto offer = [](const Record& record, const Party&, const Party& receiver, std::int64_t) {
    Record next{record.version, Standing::Named};
    next.version.owner = receiver.self;
    return next;
  };
  expectFound(search(with({.offer = offer})),
              {"an old tenure begins anew", "a tenure has two owners"});
}

TEST(Defects, AnOwnerThatNamesAnotherAndGoesOn) {
  const auto owns = [](const Record& record, const Incarnation& self) {
    return wells::owns(record, self) ||
           (record.version.adopter == self && record.version.epoch == 1);
  };
  expectFound(search(with({.owns = owns}), safety()), {"two peers act as owners in one term"});
}

TEST(Defects, LearningBackwards) {
  const auto learnOffer = [](const Record& record,
                             const Version& version) -> std::optional<Record> {
    if (version == record.version) return std::nullopt;
    return Record{version, Standing::Named};
  };
  expectFound(search(with({.learnOffer = learnOffer})), {"a peer goes back to a lower version"});
}

TEST(Defects, ATieThatArrivalDecides) {
  const auto learnState = [](const Record& record,
                             const Version& version) -> std::optional<Record> {
    if (version.generation == record.version.generation && version.term == record.version.term &&
        version.adopter != record.version.adopter)
      return Record{version, Standing::Heard};
    return wells::learnState(record, version);
  };
  expectFound(search(with({.learnState = learnState}), safety()),
              {"a peer goes back to a lower version"});
}

TEST(Defects, AReceiverThatIsNeverTakenForHeard) {
  const auto learnState = [](const Record& record,
                             const Version& version) -> std::optional<Record> {
    if (version <= record.version) return std::nullopt;
    return Record{version, Standing::Heard};
  };
  expectFound(search(with({.learnState = learnState})), {"does not heal"});
}

TEST(Defects, AnHonestVersionTakenForImpossible) {
  const auto isPossible = [](const Version& version) {
    return wells::isPossible(version) && version.epoch < 2;
  };
  expectFound(search(with({.isPossible = isPossible})),
              {"an honest message is refused", "a version that nobody can have made"});
}

TEST(Defects, TwoAdoptersTakenForOneTenure) {
  const auto contradicts = [](const Record& record, const Version& version) {
    return record.version.owner != Incarnation{} && record.version.term == version.term &&
           record.version.epoch == version.epoch && record.version.owner != version.owner;
  };
  expectFound(search(with({.contradicts = contradicts}), safety()),
              {"an honest message is refused"});
}

TEST(Defects, OffersThatAreSentOnce) {
  expectFound(search(with({.offers = Conduct::Offers::SentOnce})), {"does not heal"});
}

TEST(Defects, OffersThatAJoinerForgets) {
  expectFound(search(with({.gathering = Conduct::Gathering::ForgetsOffers})),
              {"the records stay unequal"});
}

TEST(Defects, AJoinerThatWaitsForAgreementForEver) {
  expectFound(search(with({.agreement = Conduct::Agreement::ForEver})),
              {"a peer never becomes active"});
}

TEST(Defects, AJoinerThatIsActiveBeforeItHasHeardOfTheBalls) {
  expectFound(search(with({.activation = Conduct::Activation::Blind})),
              {"an active peer knows nothing of the ball",
               "two peers act as owners though nothing has failed"});
}

TEST(Defects, ALeaseThatANewIncarnationRenews) {
  expectFound(search(with({.lease = Conduct::Lease::OfPeer})), {"does not heal"});
}

TEST(Defects, AreFoundAmongTwoBallsToo) {
  Limits limits = kLimits;
  limits.balls = 2;
  const Result found = search(with({.offers = Conduct::Offers::SentOnce}), limits);
  EXPECT_EQ(found.outcome, Outcome::Violated);
  EXPECT_TRUE(contains(found.trace, "ball 1")) << found.trace;
}

// Nobody has to act strangely for the shortest trace of this one: it can be told by hand. A founds,
// B enters, has heard and is active, A offers, and the offer is lost.
TEST(Defects, TheTraceIsTheShortest) {
  const Result found = search(with({.offers = Conduct::Offers::SentOnce}));
  EXPECT_TRUE(contains(found.trace, "\n5. ")) << found.trace;
  EXPECT_FALSE(contains(found.trace, "\n6. ")) << found.trace;
}

}  // namespace
}  // namespace wells
