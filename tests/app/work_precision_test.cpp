// The analysis of error against CPU time, on made-up runs whose answer is known.
#include "work_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "errors.h"
#include "ladder_json.h"

namespace wells {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

WorkPoint point(double dt, double error, double cpu) {
  WorkPoint point;
  point.dt = dt;
  point.error = error;
  point.cpu = cpu;
  return point;
}

/// error = factor dt^order, never below `rounding`; one step costs 1 us.
std::vector<WorkPoint> ofOrder(double order, double factor, int count, double rounding = 0) {
  std::vector<WorkPoint> points;
  for (int rung = 0; rung < count; ++rung) {
    const double dt = 0.1 * std::ldexp(1.0, -rung);
    points.push_back(point(dt, std::max(rounding, factor * std::pow(dt, order)), 1e-6 / dt));
  }
  return points;
}

TEST(StepLadder, DividesTheDurationByDoubling) {
  // 10 s by 2/15, 1/15, 1/30, 1/60 s.
  EXPECT_EQ(stepLadder(10, 2.0 / 15, 4), (std::vector<std::int64_t>{75, 150, 300, 600}));
}

TEST(StepLadder, TakesTheNearestDivisorOfAnOddDuration) {
  // 1 s by 0.3, 0.15, 0.075 s is 3.33, 6.67, 13.3 steps.
  EXPECT_EQ(stepLadder(1, 0.3, 3), (std::vector<std::int64_t>{3, 7, 13}));
}

TEST(StepLadder, HasNoNumberTwiceAndNoneBelowTwo) {
  // 1 s by 4, 2, 1, 0.5, 0.25 s.
  EXPECT_EQ(stepLadder(1, 4, 5), (std::vector<std::int64_t>{2, 4}));
}

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({8, 1, 2, 4}), 3);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(FittedOrder, IsTheExponentOfAPower) {
  for (const double order : {1.0, 2.0, 4.0}) {
    const auto fitted = fittedOrder(ofOrder(order, 0.5, 8));
    ASSERT_TRUE(fitted) << order;
    EXPECT_NEAR(*fitted, order, 1e-12);
  }
}

TEST(FittedOrder, LeavesOutRoundingAndCoarseSteps) {
  // Rounding stops the fall at 3e-12; a coarse start that says nothing is put in front.
  auto points = ofOrder(4, 0.5, 14, 3e-12);
  points.insert(points.begin(), {point(0.4, kInfinity, 1e-6), point(0.2, 7.0, 2e-6)});
  const auto fitted = fittedOrder(points);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(*fitted, 4, 1e-9);
}

TEST(FittedOrder, LeavesOutRoundingThatGrows) {
  // From 1e-10 m on, each halving of the step doubles the number of roundings.
  auto points = ofOrder(4, 0.5, 8);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].error < 1e-9) points[i].error = 1e-13 * std::ldexp(1.0, static_cast<int>(2 * i));
  const auto fitted = fittedOrder(points);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(*fitted, 4, 1e-9);
}

TEST(FittedOrder, LeavesOutLongStepsThatAnEngineDivides) {
  // The third is the same run as the fourth, the first as the second.
  auto points = ofOrder(2, 0.5, 8);
  points[2].error = points[3].error;
  points[0].error = points[1].error = 1.5 * points[2].error;
  const auto fitted = fittedOrder(points);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(*fitted, 2, 1e-12);
}

TEST(FittedOrder, IsTheLeastSquaresLineOfScatteredPoints) {
  // log2 of the errors: 0, 2, 1 below 2^-4 for dt = 1/4, 1/2, 1; by hand the slope is 1/2.
  const std::vector<WorkPoint> points = {point(1, std::ldexp(1, -3), 1), point(.5, .25, 2),
                                         point(.25, std::ldexp(1, -4), 4)};
  EXPECT_NEAR(fittedOrder(points).value_or(0), 0.5, 1e-12);
}

TEST(FittedOrder, IsNothingForExactAndForHopelessMethods) {
  EXPECT_FALSE(fittedOrder({}));
  EXPECT_FALSE(fittedOrder(ofOrder(1, 1e-13, 8)));
  EXPECT_FALSE(fittedOrder(ofOrder(0, 5, 8)));
}

TEST(IsAtRounding, WantsASmallErrorThatNoLongerFalls) {
  EXPECT_TRUE(isAtRounding(ofOrder(0, 1e-13, 8)));
  EXPECT_FALSE(isAtRounding(ofOrder(0, 1e-13, 7))) << "too few to be sure";
  EXPECT_FALSE(isAtRounding(ofOrder(0, 1e-3, 12))) << "stuck at another answer";
  EXPECT_FALSE(isAtRounding(ofOrder(1, 1e-12, 12))) << "still falls";
}

TEST(Cheapest, IsOnTheLineBetweenTwoPointsInTheLogarithms) {
  // From 1e-2 m at 1 ms to 1e-6 m at 100 ms: half way down is half way across.
  const std::vector<WorkPoint> points = {point(.1, 1e-2, 1e-3), point(.01, 1e-6, 1e-1)};
  EXPECT_NEAR(cheapest(points, 1e-4).value_or(0), 1e-2, 1e-12);
  EXPECT_NEAR(cheapest(points, 1e-3).value_or(0), std::pow(10, -2.5), 1e-12);
  EXPECT_NEAR(cheapest(points, 1e-6).value_or(0), 1e-1, 1e-12);
  EXPECT_EQ(cheapest(points, 1e-1), 1e-3) << "no coarser one was run";
  EXPECT_FALSE(cheapest(points, 1e-7));
}

TEST(Cheapest, CountsALuckyPointAndDoesNotInterpolateFromInfinity) {
  const std::vector<WorkPoint> points = {point(.4, kInfinity, 1), point(.2, 1e-5, 2),
                                         point(.1, 1e-2, 4), point(.05, 1e-6, 8)};
  EXPECT_EQ(cheapest(points, 1e-4), 2);
  EXPECT_EQ(cheapest({points.data(), 1}, 1e-4), std::nullopt);
}

TEST(Cheapest, TakesAnErrorOfExactlyZero) {
  const std::vector<WorkPoint> points = {point(.2, 1e-2, 2), point(.1, 0, 4)};
  EXPECT_EQ(cheapest(points, 1e-9), 4);
}

TEST(Soonest, NamesTheBestAndWhatAllHaveTried) {
  const std::vector<Ladder> ladders = {
      {{"ours", "leapfrog", "exact"}, {point(.1, 1e-4, 5)}, {}},
      {{"ours", "pefrl", "exact"}, {point(.1, 1e-4, 3), point(.05, 1e-8, 6)}, {}},
      {{"ours", "heun", "exact"}, {}, {}}};
  const Reach reach = soonest(ladders, 1e-3);
  EXPECT_EQ(reach.cpu, 3);
  EXPECT_EQ(reach.method, "ours pefrl exact");
  EXPECT_EQ(reach.tried, 5);
  EXPECT_FALSE(soonest(ladders, 1e-9).cpu);
}

TEST(RatioText, SaysWhatIsKnown) {
  const Reach fast{2e-4, "a", 1};
  EXPECT_EQ(ratioText(fast, {6.24e-2, "b", 1}), "312");
  EXPECT_EQ(ratioText(fast, {2.5e-4, "b", 1}), "1.25");
  EXPECT_EQ(ratioText(fast, {{}, "", 0.5}), ">= 2500 (never reached)");
  EXPECT_EQ(ratioText({{}, "", 1}, {1e-3, "b", 1}), "ours never reached it");
  EXPECT_EQ(ratioText(fast, {}), "not run");
}

TEST(LadderJson, BringsBackTheSameBits) {
  Ladder ladder{{"bullet", "symplectic-euler", "sequential-impulse"},
                {point(1.0 / 60, kInfinity, 0.1)},
                {"dt = 1 s: \"given up\""}};
  ladder.points[0].energyError = std::numeric_limits<double>::quiet_NaN();
  ladder.points[0].steps = 600;
  ladder.points[0].escaped = 2;
  ladder.points[0].repeats = 3;
  ladder.points[0].stateHash = ~std::uint64_t{0};
  const std::vector<Ladder> back = laddersFromJson(laddersAsJson({&ladder, 1}));
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].method, ladder.method);
  EXPECT_EQ(back[0].notes, ladder.notes);
  ASSERT_EQ(back[0].points.size(), 1u);
  const WorkPoint& p = back[0].points[0];
  EXPECT_EQ(p.dt, 1.0 / 60);
  EXPECT_EQ(p.steps, 600);
  EXPECT_EQ(p.error, kInfinity);
  EXPECT_TRUE(std::isnan(p.energyError));
  EXPECT_EQ(p.escaped, 2);
  EXPECT_EQ(p.cpu, 0.1);
  EXPECT_EQ(p.repeats, 3);
  EXPECT_EQ(p.stateHash, ~std::uint64_t{0});
}

TEST(LadderJson, RefusesWhatItDidNotWrite) {
  for (const char* text : {"", "{", "[{}]", "[1]"})
    EXPECT_THROW(laddersFromJson(text), RunError) << text;
}

}  // namespace
}  // namespace wells
