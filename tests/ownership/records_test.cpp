#include "ownership/records.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <tuple>

#include "math/random.h"

namespace wells {
namespace {

const Generation kGeneration{0, 1000, 1};
const Incarnation kA{PeerId{1}, 11};
const Incarnation kB{PeerId{2}, 22};
const Incarnation kC{PeerId{3}, 33};

Party active(const Incarnation& self) {
  return {self, Phase::Active};
}

TEST(Records, TheFounderOwns) {
  const Record record = found(kGeneration, kA, 0);
  EXPECT_TRUE(owns(record, kA));
  EXPECT_FALSE(owns(record, kB));
  EXPECT_FALSE(owns(record, {kA.peer, 12})) << "another incarnation of the founder";
}

TEST(Records, KnowingNothingIsLessThanEveryRecordOfTheGeneration) {
  const Record nothing = unknown(kGeneration);
  EXPECT_LT(nothing.version, found(kGeneration, kA, 0).version);
  EXPECT_LT(found({0, 1001, 1}, kA, 99).version, nothing.version) << "a lesser generation";
}

TEST(Records, AnOfferEndsOwnershipInTheActAndTheReceiverBeginsTheNextEpoch) {
  const Record owned = found(kGeneration, kA, 0);
  const Record given = offer(owned, active(kA), active(kB), 60);
  EXPECT_FALSE(owns(given, kA));
  EXPECT_FALSE(owns(given, kB)) << "not before it has accepted";
  EXPECT_EQ(given.version.epoch, 1);
  EXPECT_EQ(given.version.step, 60);

  const auto learned = learnOffer(owned, given.version);
  ASSERT_TRUE(learned);
  const Record taken = take(*learned, active(kB));
  EXPECT_TRUE(owns(taken, kB));
  EXPECT_EQ(taken.version, given.version);
}

TEST(Records, TheReceiverIsHeardWhenItPublishesEvenAtTheStepOfTheOffer) {
  const Record given = offer(found(kGeneration, kA, 0), active(kA), active(kB), 60);
  const auto heard = learnState(given, given.version);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->standing, Standing::Heard);
  EXPECT_FALSE(learnState(*heard, given.version)) << "once is enough";
}

TEST(Records, AnOfferThatIsRepeatedDoesNotUnseatTheReceiver) {
  const Record given = offer(found(kGeneration, kA, 0), active(kA), active(kB), 60);
  const Record published = publish(take(given, active(kB)), active(kB), 61);
  EXPECT_FALSE(learnOffer(published, given.version));
}

TEST(Records, ABallThatIsNotWantedGoesBackUnderANewEpoch) {
  const Record given = offer(found(kGeneration, kA, 0), active(kA), active(kB), 60);
  const Record back = offer(take(given, active(kB)), active(kB), active(kA), 62);
  EXPECT_EQ(back.version.owner, kA);
  EXPECT_EQ(back.version.epoch, 2);
  EXPECT_EQ(back.standing, Standing::Named);
  EXPECT_GT(back.version, given.version);
}

TEST(Records, OnlyWhoIsActiveAndMeantMayAct) {
  const Record owned = found(kGeneration, kA, 0);
  const Record given = offer(owned, active(kA), active(kB), 60);
  const Incarnation otherB{kB.peer, kB.number + 1};
  EXPECT_TRUE(mayTake(given, active(kB)));
  EXPECT_FALSE(mayTake(given, active(otherB))) << "an offer is to one incarnation";
  EXPECT_FALSE(mayTake(given, {kB, Phase::Syncing}));
  EXPECT_FALSE(mayTake(take(given, active(kB)), active(kB))) << "once is enough";
  EXPECT_TRUE(mayOffer(owned, active(kA), active(kB)));
  EXPECT_FALSE(mayOffer(owned, active(kB), active(kC))) << "somebody else's ball";
  EXPECT_FALSE(mayOffer(owned, {kA, Phase::Syncing}, active(kB)));
  EXPECT_FALSE(mayOffer(owned, active(kA), {kB, Phase::Syncing})) << "a joiner is offered nothing";
  EXPECT_FALSE(mayOffer(owned, active(kA), active({kA.peer, 77}))) << "our own id";
  EXPECT_FALSE(mayOffer(given, active(kA), active(kC))) << "naming was giving up";
  EXPECT_TRUE(mayAdopt(owned, active(kB), Life::Ended));
  EXPECT_FALSE(mayAdopt(owned, active(kB), Life::Lasts));
  EXPECT_FALSE(mayAdopt(owned, {kB, Phase::Joining}, Life::Ended));
  EXPECT_FALSE(mayAdopt(owned, active(kA), Life::Ended)) << "from ourselves";
  EXPECT_TRUE(mayPublish(owned, active(kA)));
  EXPECT_FALSE(mayPublish(owned, active(kB)));
  EXPECT_FALSE(mayPublish(owned, {kA, Phase::Leaving}));
}

TEST(Records, AnAdopterBeginsATermThatOutweighsTheOldOwner) {
  Record old = found(kGeneration, kA, 0);
  for (int i = 0; i < 5; ++i)
    old = take(offer(old, active(i % 2 ? kB : kA), active(i % 2 ? kA : kB), i),
               active(i % 2 ? kA : kB));
  const Record adopted = adopt(old, active(kC), 3);
  EXPECT_TRUE(owns(adopted, kC));
  EXPECT_EQ(adopted.version.term, 1);
  EXPECT_EQ(adopted.version.epoch, 0);
  EXPECT_GT(adopted.version, old.version);
  EXPECT_FALSE(learnState(adopted, publish(old, active(kB), 1000).version)) << "never goes back";
  EXPECT_TRUE(learnState(old, adopted.version));
}

TEST(Records, OfTwoAdoptersTheGreaterWinsEverywhere) {
  const Record old = found(kGeneration, kA, 0);
  const Record b = adopt(old, active(kB), 10);
  const Record c = adopt(old, active(kC), 10);
  EXPECT_FALSE(learnState(c, b.version));
  EXPECT_TRUE(learnState(b, c.version));
}

TEST(Records, RefusesVersionsThatNobodyCanHaveMade) {
  EXPECT_TRUE(isPossible(found(kGeneration, kA, 0).version));
  EXPECT_TRUE(isPossible(adopt(found(kGeneration, kA, 0), active(kB), 1).version));
  EXPECT_FALSE(isPossible({kGeneration, 0, kA, 0, kA, 0})) << "an adopter in the first term";
  EXPECT_FALSE(isPossible({kGeneration, 1, {}, 0, kA, 0})) << "a later term without an adopter";
  EXPECT_FALSE(isPossible({kGeneration, 1, kB, 0, kA, 0})) << "epoch 0 is the adopter's";
  EXPECT_FALSE(isPossible({kGeneration, 1, {kB.peer, 0}, 1, kA, 0}));
  EXPECT_FALSE(isPossible({kGeneration, 0, {}, 0, {}, 0})) << "nobody owns";
  EXPECT_FALSE(isPossible({kGeneration, -1, {}, 0, kA, 0}));
}

TEST(Records, NoticesASecondOwnerOfATenure) {
  const Record owned = found(kGeneration, kA, 0);
  EXPECT_TRUE(contradicts(owned, found(kGeneration, kB, 5).version));
  EXPECT_FALSE(contradicts(owned, publish(owned, active(kA), 5).version));
  EXPECT_FALSE(contradicts(unknown(kGeneration), owned.version)) << "who knows nothing learns";
}

// Three peers do what they may in any order, over a network that loses, repeats and reorders
// anything. Whatever happens, versions rise and a tenure has one owner.
TEST(Records, RandomHistoriesNeverGiveATenureTwoOwners) {
  const std::array peers{kA, kB, kC};
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    std::array<Record, 3> records;
    records.fill(unknown(kGeneration));
    records[0] = found(kGeneration, kA, 0);
    std::vector<Record> sent;
    std::map<std::tuple<std::int64_t, Incarnation, std::int64_t>, Incarnation> owners;
    for (std::int64_t step = 1; step <= 200; ++step) {
      const auto me = static_cast<std::size_t>(random.below(3));
      const Party self = active(peers[me]);
      Record& mine = records[me];
      const Record before = mine;
      switch (random.below(5)) {
        case 0:
          if (mayPublish(mine, self)) sent.push_back(mine = publish(mine, self, step));
          break;
        case 1:
          if (const Party receiver = active(peers[random.below(3)]); mayOffer(mine, self, receiver))
            sent.push_back(mine = offer(mine, self, receiver, step));
          break;
        case 2:  // any suspicion, right or wrong
          if (random.below(8) == 0 && mayAdopt(mine, self, Life::Ended))
            sent.push_back(mine = adopt(mine, self, step));
          break;
        default:
          if (sent.empty()) break;
          const Record& news = sent[random.below(sent.size())];
          const auto next = news.standing == Standing::Heard ? learnState(mine, news.version)
                                                             : learnOffer(mine, news.version);
          if (next) mine = *next;
          if (mayTake(mine, self)) mine = take(mine, self);
      }
      ASSERT_GE(mine.version, before.version) << "seed " << seed;
      const Version& v = mine.version;
      if (v.owner == Incarnation{}) continue;
      ASSERT_TRUE(isPossible(v)) << "seed " << seed;
      const auto known = owners.try_emplace({v.term, v.adopter, v.epoch}, v.owner).first;
      ASSERT_EQ(known->second, v.owner) << "seed " << seed << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace wells
