#include "network/shared_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace wells {
namespace {

Register value(const std::string& text, std::int64_t version, std::int64_t setter = 1,
               std::int64_t from = 0) {
  return {text, version, setter, "somebody", from};
}

TEST(SharedSettings, TheGreatestVersionAndSetterHoldsInWhateverOrderTheyCome) {
  std::vector<Register> values{value("0.1", 1, 9), value("0.2", 2, 3), value("0.3", 2, 5),
                               value("0.4", 1, 7)};
  std::ranges::sort(values, {}, &Register::value);
  do {
    SharedSettings shared;
    for (const Register& r : values) shared.learn("Elasticity", r);
    EXPECT_EQ(shared.registers().at("Elasticity").value, "0.3");
  } while (std::ranges::next_permutation(values, {}, &Register::value).found);
}

TEST(SharedSettings, AValueHoldsFromItsStepOn) {
  SharedSettings shared;
  shared.learn(setting::kGravity, value("reversed", 1, 1, 100));
  shared.learn(setting::kElasticity, value("0.25", 1, 1, 50));
  shared.learn(setting::kFriction, value("0", 1, 1, 50));
  shared.learn(setting::kRollingResistance, value("0.002", 1, 1, 60));
  Settings world;
  EXPECT_EQ(applied(shared, world, 49).elasticity, world.elasticity);
  EXPECT_EQ(applied(shared, world, 50).elasticity, 0.25);
  EXPECT_EQ(applied(shared, world, 50).friction, 0);
  EXPECT_EQ(applied(shared, world, 59).rollingResistance, world.rollingResistance);
  EXPECT_EQ(applied(shared, world, 60).rollingResistance, 0.002);
  EXPECT_EQ(applied(shared, world, 99).gravity, world.gravity);
  EXPECT_EQ(applied(shared, world, 100).gravity, Vec3(-world.gravity));
  shared.learn(setting::kGravity, value("off", 2, 1, 120));
  EXPECT_EQ(applied(shared, world, 120).gravity, Vec3(Vec3::Zero()));
  shared.restart();
  EXPECT_EQ(applied(shared, world, 0).elasticity, 0.25) << "the world starts over with them";
}

TEST(SharedSettings, UntilItsStepComesTheValueBeforeItHolds) {
  SharedSettings shared;
  Settings world;
  shared.learn(setting::kElasticity, value("0.25", 1, 1, 50));
  shared.learn(setting::kElasticity, value("0.5", 2, 1, 100));
  EXPECT_EQ(applied(shared, world, 49).elasticity, world.elasticity);
  EXPECT_EQ(applied(shared, world, 99).elasticity, 0.25);
  EXPECT_EQ(applied(shared, world, 100).elasticity, 0.5);
  shared.restart();
  EXPECT_EQ(applied(shared, world, 0).elasticity, 0.5);
  shared.clear();
  EXPECT_EQ(applied(shared, world, 100).elasticity, world.elasticity);
}

TEST(SharedSettings, APauseEndsAtOnceForTheStepAtWhichItWouldEndNeverComes) {
  SharedSettings shared;
  shared.learn(setting::kPause, value("true", 1, 1, 50));
  EXPECT_TRUE(isPaused(shared, 50));
  shared.learn(setting::kPause, value("false", 2, 1, 80));
  EXPECT_FALSE(isPaused(shared, 50));
  shared.learn(setting::kPause, value("true", 3, 1, 90));
  EXPECT_FALSE(isPaused(shared, 89));
  EXPECT_TRUE(isPaused(shared, 90));
}

TEST(SharedSettings, PauseAndPaceAndResets) {
  SharedSettings shared;
  EXPECT_FALSE(isPaused(shared, 0));
  EXPECT_EQ(stepRate(shared, 0, 60), 60);
  EXPECT_EQ(resetsAsked(shared), 0);
  shared.learn(setting::kPause, value("true", 1, 1, 10));
  shared.learn(setting::kSimulationRate, value("30", 1, 1, 10));
  shared.learn(setting::kReset, value("3", 1, 1, 10));
  EXPECT_FALSE(isPaused(shared, 9));
  EXPECT_TRUE(isPaused(shared, 10));
  EXPECT_EQ(stepRate(shared, 10, 60), 30);
  EXPECT_EQ(resetsAsked(shared), 3);
}

TEST(SharedSettings, TheNextValueOutweighsTheOneThatIsKnown) {
  SharedSettings shared;
  shared.learn("Pause", value("true", 7, 1000));
  EXPECT_TRUE(shared.learn("Pause", shared.next("Pause", "false", -5, "me", 20)));
  EXPECT_EQ(shared.registers().at("Pause"), (Register{"false", 8, -5, "me", 20}));
  EXPECT_EQ(shared.next("Friction", "1", 4, "me", 0).version, 1);
}

TEST(SharedSettings, DigestsAgreeWhereTheSameIsKnown) {
  SharedSettings a, b;
  EXPECT_EQ(a.digest(), 0u);
  a.learn("Pause", value("true", 1));
  a.learn("Friction", value("1", 2));
  EXPECT_NE(a.digest(), b.digest());
  b.learn("Friction", value("1", 2));
  b.learn("Pause", value("true", 1));
  EXPECT_EQ(a.digest(), b.digest());
  b.learn("Pause", value("true", 1, 2));
  EXPECT_NE(a.digest(), b.digest()) << "another setter";
}

TEST(SharedSettings, InventedKeysDoNotFillTheMemory) {
  SharedSettings shared;
  for (std::size_t i = 0; i < 2 * kMaxSharedSettings; ++i)
    EXPECT_EQ(shared.learn(std::to_string(i), value("1", 1)), i < kMaxSharedSettings);
}

TEST(SharedSettings, RefusesWhatIsNotAllowedAndSaysWhatIs) {
  for (const auto& [key, good] :
       std::vector<std::pair<std::string, std::string>>{{"Pause", "true"},
                                                        {"Pause", "false"},
                                                        {"SimulationRate", "10"},
                                                        {"SimulationRate", "10000"},
                                                        {"Gravity", "on"},
                                                        {"Gravity", "off"},
                                                        {"Gravity", "reversed"},
                                                        {"Elasticity", "0"},
                                                        {"Elasticity", "1"},
                                                        {"Friction", "0.3"},
                                                        {"RollingResistance", "0"},
                                                        {"Reset", "1"}})
    EXPECT_EQ(checkSessionSetting(key, good), std::nullopt) << key << "=" << good;
  for (const auto& [key, bad] :
       std::vector<std::pair<std::string, std::string>>{{"Pause", "yes"},
                                                        {"Pause", ""},
                                                        {"SimulationRate", "9.9"},
                                                        {"SimulationRate", "1e9"},
                                                        {"SimulationRate", "nan"},
                                                        {"Gravity", "sideways"},
                                                        {"Elasticity", "1.5"},
                                                        {"Elasticity", "-0.1"},
                                                        {"Elasticity", "0.5x"},
                                                        {"Friction", "inf"},
                                                        {"Friction", "-1"},
                                                        {"RollingResistance", "-1e-9"},
                                                        {"RollingResistance", "nan"},
                                                        {"Reset", "0"},
                                                        {"Reset", "1.5"},
                                                        {"Reset", "99999999999999999999"}}) {
    const auto wrong = checkSessionSetting(key, bad);
    ASSERT_TRUE(wrong) << key << "=" << bad;
    EXPECT_NE(wrong->find(key + " is " + bad + "; it must be "), std::string::npos) << *wrong;
  }
  EXPECT_EQ(checkSessionSetting("Gravty", "on"), "Gravty: no such setting");
}

}  // namespace
}  // namespace wells
