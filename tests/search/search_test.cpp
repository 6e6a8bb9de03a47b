// The real rules keep their promises in everything that can happen within limits.
#include "search/search.h"

#include <gtest/gtest.h>

#include <set>

namespace wells {
namespace {

Result search(const Limits& limits) {
  return Search(limits, {}).run();
}

void expectClosed(const Limits& limits) {
  const Result result = search(limits);
  EXPECT_EQ(name(result.outcome), "closed") << result.violation << "\n" << result.trace;
  EXPECT_GT(result.progress.states, 50u);
}

TEST(Search, NothingBreaksWithoutFaults) {
  expectClosed({.balls = 1, .epochs = 6, .terms = 1, .suspicions = 0, .crashes = 0, .restarts = 0});
  expectClosed({.balls = 2, .epochs = 4, .terms = 1, .suspicions = 0, .crashes = 0, .restarts = 0});
}

TEST(Search, OneBallSurvivesTwoSuspicionsACrashAndARestart) {
  expectClosed({.balls = 1, .epochs = 2, .terms = 2});
  expectClosed({.balls = 1, .epochs = 3, .terms = 2, .suspicions = 0});
}

TEST(Search, OneBallSurvivesThreeTerms) {
  expectClosed({.balls = 1, .terms = 3, .suspicions = 1, .restarts = 0});
}

TEST(Search, TwoBallsSurviveWhatOneDoes) {
  expectClosed({.balls = 2, .epochs = 2, .terms = 2, .suspicions = 1, .restarts = 0});
  expectClosed({.balls = 2, .epochs = 2, .terms = 2, .suspicions = 0});
}

TEST(Search, APeerThatStoodStillBreaksNothing) {
  expectClosed({.balls = 1, .epochs = 2, .terms = 2, .suspicions = 1, .restarts = 0, .fences = 1});
}

TEST(Search, TwoGenerationsBecomeOne) {
  expectClosed(
      {.balls = 1, .epochs = 2, .terms = 2, .suspicions = 1, .restarts = 0, .foundings = 2});
}

TEST(Search, AGenerationThatDiedOutIsLeftForALesserOne) {
  expectClosed({.balls = 1,
                .epochs = 2,
                .terms = 2,
                .suspicions = 0,
                .restarts = 0,
                .fences = 1,
                .foundings = 2});
}

TEST(Search, AResetBreaksNothing) {
  expectClosed({.balls = 1, .epochs = 2, .terms = 2, .suspicions = 1, .restarts = 0, .resets = 1});
}

// The argument for hearing just before acting (model.h): in the end the same cases were looked at,
// though on fewer ways.
TEST(Search, HearingLateMissesNothing) {
  for (Limits limits :
       {Limits{.balls = 1, .terms = 2, .suspicions = 0},
        Limits{.balls = 1, .epochs = 2, .terms = 3, .suspicions = 1, .restarts = 0},
        Limits{.balls = 1, .epochs = 2, .terms = 2, .suspicions = 0, .restarts = 0, .fences = 1},
        Limits{.balls = 1, .terms = 2, .suspicions = 0, .restarts = 0, .foundings = 2}}) {
    const Result late = search(limits);
    limits.hearing = Hearing::AtAnyTime;
    const Result any = search(limits);
    EXPECT_EQ(late.outcome, Outcome::Closed);
    EXPECT_EQ(any.outcome, Outcome::Closed);
    EXPECT_EQ(late.progress.cases, any.progress.cases);
    EXPECT_LT(late.progress.states, any.progress.states);
  }
}

// The argument that one ball stands for any number (model.h).
TEST(Search, ABallAmongTwoMeetsTheCasesOfABallAlone) {
  for (Limits limits : {Limits{.balls = 1, .epochs = 2, .terms = 2, .suspicions = 1, .restarts = 0},
                        Limits{.balls = 1, .epochs = 2, .terms = 2, .suspicions = 0}}) {
    const Result one = search(limits);
    limits.balls = 2;
    const Result two = search(limits);
    EXPECT_EQ(one.outcome, Outcome::Closed);
    EXPECT_EQ(two.outcome, Outcome::Closed);
    EXPECT_EQ(one.progress.cases, two.progress.cases);
  }
}

TEST(Search, SaysThatItDidNotClose) {
  Limits limits{.balls = 1};
  limits.seconds = 0;
  EXPECT_EQ(search(limits).outcome, Outcome::OutOfTime);
  limits = {.balls = 1};
  limits.memory = 1;
  EXPECT_EQ(search(limits).outcome, Outcome::OutOfMemory);
}

}  // namespace
}  // namespace wells
