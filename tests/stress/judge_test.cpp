// The judge of the stress cases, held against engines that do one thing wrong each.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>

#include "app/stress_run.h"

namespace wells {
namespace {

/// Does nothing to the world but what it is told.
class Puppet : public Stepper {
 public:
  explicit Puppet(std::function<void(World&)> act) : act_(std::move(act)) {}
  std::string name() const override { return "puppet"; }
  std::string integrator() const override { return "none"; }
  std::string contactMethod() const override { return "none"; }
  void step(World& world) override {
    act_(world);
    ++world.step;
  }

 private:
  std::function<void(World&)> act_;
};

StressWorld oneBallAndABadOne(int) {
  StressWorld made;
  made.about = "the only version";
  made.world.balls.add({.position = {0, 5, 0}, .velocity = {1, 0, 0}}, 0.5, 2);
  made.world.balls.add({.position = {0, std::numeric_limits<double>::quiet_NaN(), 0}}, 0.5, 1);
  made.bad = 1;
  return made;
}

constexpr StressCase kCase{
    .name = "puppets", .about = "", .versions = 1, .make = oneBallAndABadOne, .steps = 4};

StressResult judged(const std::function<void(World&)>& act, const StressCase& stress = kCase) {
  return runStress(
      stress, [&] { return std::make_unique<Puppet>(act); }, 60);
}

TEST(StressJudge, FindsNothingWhereNothingHappens) {
  const StressResult result = judged([](World&) {});
  EXPECT_EQ(verdict(kCase, result), "held");
  EXPECT_EQ(result.steps, 4);
  EXPECT_EQ(result.firstBroken, "");
}

// Energy at the start: 2 kg at 5 m with 1 m/s, 99.1 J.
TEST(StressJudge, FindsEnergyFromNothing) {
  const StressResult result =
      judged([](World& world) { world.balls.velocity[0].x() = 1 + 0.5 * (world.step == 2); });
  EXPECT_EQ(verdict(kCase, result), "gained energy");
  EXPECT_NEAR(result.gain, 1.25, 1e-12);
  EXPECT_NEAR(result.relativeGain, 1.25 / (99.1 + 1.25), 1e-12);
  EXPECT_EQ(result.firstBroken, "the only version");
}

// Back to less than the start, but more than there was in between.
TEST(StressJudge, FindsEnergyThatComesBack) {
  const StressResult result =
      judged([](World& world) { world.balls.velocity[0].x() = world.step == 1 ? 0.5 : 0.9; });
  EXPECT_NEAR(result.gain, 0.81 - 0.25, 1e-12);
}

TEST(StressJudge, AllowsWhatThePromiseAllows) {
  const auto lift = [](World& world) { world.balls.position[0].y() = 5.01; };
  StressCase pressed = kCase;
  pressed.energy = EnergyPromise::Pressed;
  EXPECT_EQ(verdict(kCase, judged(lift)), "gained energy");
  EXPECT_EQ(verdict(pressed, judged(lift, pressed)), "held");

  const auto kick = [](World& world) { world.balls.velocity[0].x() = 100; };
  StressCase moving = kCase;
  moving.energy = EnergyPromise::WellsMove;
  EXPECT_EQ(verdict(moving, judged(kick, moving)), "held");
}

TEST(StressJudge, FindsLostBalls) {
  for (const Vec3& outside : {Vec3{0, -0.01, 0}, Vec3{30, 0, 30}}) {
    const auto leave = [&](World& world) {
      world.balls.position[0] = world.step == 1 ? outside : Vec3{0, 0, 0};
    };
    const StressResult result = judged(leave);
    EXPECT_EQ(result.lost, 1);
    StressCase late = kCase;
    late.apart = 2;
    EXPECT_EQ(judged(leave, late).lost, 0) << "before the start's overlaps must be gone";
  }
}

TEST(StressJudge, FindsWhatIsNotFinite) {
  const StressResult result = judged([](World& world) {
    if (world.step == 3) world.balls.spin[0].z() = std::numeric_limits<double>::infinity();
  });
  EXPECT_EQ(verdict(kCase, result), "not finite");
  EXPECT_EQ(result.notFinite, 1);
}

TEST(StressJudge, FindsInfectionByTheLastBit) {
  const StressResult result = judged([](World& world) {
    if (world.balls.size() == 2) world.balls.position[0].z() = 1e-300;
  });
  EXPECT_EQ(verdict(kCase, result), "infected");
}

TEST(StressJudge, FindsThatAnEngineGivesUp) {
  const StressResult result = judged([](World& world) {
    if (world.step == 2) throw std::runtime_error("no more");
  });
  EXPECT_EQ(verdict(kCase, result), "gave up");
  EXPECT_EQ(result.gaveUp, std::vector<std::string>{"the only version: no more"});
  EXPECT_EQ(result.steps, 2);
}

TEST(StressJudge, StopsAtTheLimit) {
  const auto sleep = [](World&) { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  const auto make = [&] { return std::make_unique<Puppet>(sleep); };
  const StressResult result = runStress(kCase, make, 0.01);
  EXPECT_TRUE(result.isOutOfTime);
  EXPECT_LT(result.steps, kCase.steps);
}

}  // namespace
}  // namespace wells
