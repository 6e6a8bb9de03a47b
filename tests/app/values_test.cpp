#include "values.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

std::string reasonOf(const std::function<void()>& parse) {
  try {
    parse();
  } catch (const BadValue& bad) {
    return bad.what();
  }
  return "accepted";
}

TEST(Values, NumbersMayEndInF) {
  EXPECT_EQ(parseNumber("40.f"), 40.0);
  EXPECT_EQ(parseNumber("1.5f"), 1.5);
  EXPECT_EQ(parseNumber("2F"), 2.0);
  EXPECT_EQ(parseNumber(" -.25 "), -0.25);
  EXPECT_EQ(parseNumber("+1e-3"), 0.001);
}

TEST(Values, RefusesWhatIsNoNumber) {
  EXPECT_EQ(reasonOf([] { parseNumber(""); }), "the value is missing");
  for (const char* text : {"abc", "1,5", "--1", "+-1", ".", "1.2.3"})
    EXPECT_EQ(reasonOf([&] { parseNumber(text); }), "not a number") << text;
  for (const char* text : {"nan", "inf", "-inf", "infinity"})
    EXPECT_EQ(reasonOf([&] { parseNumber(text); }), "not a finite number") << text;
  EXPECT_EQ(reasonOf([] { parseNumber("4.9e-324"); }), "a subnormal number");
  EXPECT_EQ(reasonOf([] { parseNumber("1e400"); }), "no double holds this number");
}

TEST(Values, RefusesUnits) {
  for (const char* text : {"40m", "40 m", "40.f m", "9.81 m/s^2", "50%", "20\u00b0"})
    EXPECT_NE(reasonOf([&] { parseNumber(text); }).find("carries no unit"), std::string::npos)
        << text;
}

TEST(Values, BooleansInEveryForm) {
  for (const char* text : {"true", "TRUE", "T", "t", "1", " True "})
    EXPECT_TRUE(parseBoolean(text));
  for (const char* text : {"false", "False", "F", "f", "0"}) EXPECT_FALSE(parseBoolean(text));
  for (const char* text : {"", "yes", "2", "tru"})
    EXPECT_EQ(reasonOf([&] { parseBoolean(text); }), "neither true nor false") << text;
}

TEST(Values, IntegersAreWholeAndInRange) {
  EXPECT_EQ(parseInteger("25", 0, 100), 25);
  EXPECT_EQ(reasonOf([] { parseInteger("2.5", 0, 100); }), "not a whole number");
  EXPECT_EQ(reasonOf([] { parseInteger("1e3", 0, 100); }), "not a whole number");
  EXPECT_EQ(reasonOf([] { parseInteger("101", 0, 100); }), "out of range");
  EXPECT_EQ(reasonOf([] { parseInteger("99999999999999999999", 0, 100); }), "out of range");
}

TEST(Values, RangesKeepTheirEnds) {
  EXPECT_TRUE(Range::between(0, 1).contains(0));
  EXPECT_FALSE(Range::above(0, 1).contains(0));
  EXPECT_TRUE(Range::above(0, 1).contains(1));
  EXPECT_FALSE(Range::between(0, 1).contains(1.0000001));
  EXPECT_EQ(Range::above(0, 1000).text(), "above 0 to 1000");
}

TEST(Values, VectorsNameTheBadPart) {
  EXPECT_EQ(parseVector("1, 2.f ,-3"), Vec3(1, 2, -3));
  EXPECT_EQ(reasonOf([] { parseVector("1,2"); }), "2 number(s) instead of 3");
  EXPECT_EQ(reasonOf([] { parseVector("1,b,3"); }), "y=b: not a number");
}

TEST(Values, NumbersReadBackTheSame) {
  for (const double x : {1.0 / 60, 0.1, 40.0, -9.81, 1e-300, 123456789.123456789, 1e15})
    EXPECT_EQ(parseNumber(formatNumber(x)), x);
}

TEST(Values, NearestWordFindsTyposAndLeavesOthersAlone) {
  const std::vector<std::string> names = {"BallRadius", "BallMass", "Elasticity", "PeerID"};
  EXPECT_EQ(nearestWord("Elastisity", names), "Elasticity");
  EXPECT_EQ(nearestWord("ballradius", names), "BallRadius");
  EXPECT_EQ(nearestWord("PeerId", names), "PeerID");
  EXPECT_EQ(nearestWord("Temperature", names), "");
}

}  // namespace
}  // namespace wells
