// The definition of "settled", on made-up kinetic energies.
#include "world/settling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wells {
namespace {

TEST(Settling, TakesTwoSecondsBelowAThousandthOfThePeak) {
  Settling settling;
  settling.add(0, 0);
  settling.add(1, 500);
  settling.add(2, 1000);  // the peak
  settling.add(3, 1);     // a thousandth, not below
  settling.add(4, 0.999);
  EXPECT_FALSE(settling.isSettled());
  settling.add(5.75, 0.999);
  EXPECT_FALSE(settling.isSettled());
  settling.add(6, 0.999);
  EXPECT_TRUE(settling.isSettled());
  EXPECT_EQ(settling.peak(), 1000);
}

TEST(Settling, StartsOverWhenSomethingMoves) {
  Settling settling;
  settling.add(0, 1000);
  settling.add(1, 0.5);
  settling.add(2, 2);
  settling.add(3, 0.5);
  settling.add(4.75, 0.5);
  EXPECT_FALSE(settling.isSettled());
  settling.add(5, 0.5);
  EXPECT_TRUE(settling.isSettled());
  settling.add(6, 2);
  EXPECT_FALSE(settling.isSettled());
}

TEST(Settling, IsSoForAWorldThatNeverMovesAndNotForOneThatStartsAtRestAndFalls) {
  Settling still;
  Settling falling;
  for (double t = 0; t <= 2; t += 0.25) {
    EXPECT_FALSE(still.isSettled()) << t;
    still.add(t, 0);
    falling.add(t, t * t);
  }
  EXPECT_TRUE(still.isSettled());
  EXPECT_FALSE(falling.isSettled());
}

TEST(Settling, IsNotWhereTheEnergyIsNotANumber) {
  Settling settling;
  for (int t = 0; t < 5; ++t) settling.add(t, std::nan(""));
  EXPECT_FALSE(settling.isSettled());
}

}  // namespace
}  // namespace wells
