// --target-error against exact answers, and against a scan of all methods and steps.
#include "choose_method.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engines.h"
#include "flight/integrators.h"
#include "forces/field.h"
#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "scenes/unit_balls.h"
#include "step_work.h"

namespace wells {
namespace {

TrialWorld worldOf(const World& start) {
  return [start](double dt) {
    World now = start;
    now.settings.dt = dt;
    return TrialStart{now, {}};
  };
}

Choice choiceFor(const World& start, double duration, double error) {
  const Settings& now = start.settings;
  return chooseMethod(worldOf(start),
                      {.error = error,
                       .duration = duration,
                       .dt = now.dt,
                       .method = {now.integrator, now.contactMethod, now.substeps}},
                      [](const std::string&) {});
}

World with(World world, const TrialMethod& method, double dt) {
  world.settings.dt = dt;
  world.settings.integrator = method.integrator;
  world.settings.contactMethod = method.contacts;
  world.settings.substeps = method.substeps;
  return world;
}

/// s, estimated; the world is then at its end. Stops where it is more than `most`.
double runFor(World& world, std::int64_t steps, double most) {
  const auto stepper = makeEngine("ours");
  const Settings& settings = world.settings;
  const StepShape shape{.balls = world.balls.size(),
                        .wells = world.tracks.size(),
                        .evaluations = findIntegrator(settings.integrator).evaluations,
                        .substeps = settings.substeps,
                        .iterations = settings.iterations};
  double work = 0;
  for (std::int64_t step = 0; step < steps && work <= most; ++step) {
    stepper->step(world);
    work += stepWork(stepper->counts(), shape);
  }
  return work;
}

std::int64_t stepsOf(double duration, double dt) {
  return std::llround(duration / dt);
}

/// The case of an impact on a wall, of an orbit, of impacts on a bent path and of a ball that rolls
/// round the wall, where long steps are divided alike, too.
class Exact : public testing::TestWithParam<std::tuple<const char*, int>> {
 protected:
  const AccuracyCase& answer = findAccuracyCase(std::get<0>(GetParam()));
  const World start = makeScene(findScene(answer.scene));
  const double error = std::pow(10, -std::get<1>(GetParam()));  // m
  const Choice choice = choiceFor(start, answer.duration, error);
};

TEST_P(Exact, TheErrorIsReachedAndForHalfTheCostByNothing) {
  EXPECT_EQ(choice.duration, answer.duration) << choice.whyShorter;
  World chosen = with(start, choice.best.method, choice.best.dt);
  runFor(chosen, stepsOf(answer.duration, choice.best.dt), 1e9);
  EXPECT_NEAR(chosen.time(), answer.duration, 1e-9 * answer.duration);
  EXPECT_LE(positionError(answer, chosen), error);

  const double half = choice.best.work / 2;
  for (const Integrator& integrator : integrators())
    for (const ContactMethod contacts : {ContactMethod::Exact, ContactMethod::Substep})
      for (double dt = kLongestStep; dt > kShortestStep; dt /= std::sqrt(2)) {
        const std::int64_t steps = stepsOf(answer.duration, dt);
        const TrialMethod method{std::string(integrator.name), contacts, 4};
        World world = with(start, method, answer.duration / static_cast<double>(steps));
        if (runFor(world, steps, half) > half) break;
        EXPECT_GT(positionError(answer, world), error) << name(method) << ", dt = " << dt;
      }
}

std::string nameOf(const testing::TestParamInfo<std::tuple<const char*, int>>& test) {
  std::string text = std::get<0>(test.param);
  std::erase(text, '-');
  return text + "_1e_" + std::to_string(std::get<1>(test.param));
}

INSTANTIATE_TEST_SUITE_P(Cases, Exact,
                         testing::Combine(testing::Values("circle-billiard", "orbit", "orbit-short",
                                                          "well-bounces"),
                                          testing::Range(3, 11)),
                         nameOf);

// Rounding at each step counts from 1e-10 m on.
INSTANTIATE_TEST_SUITE_P(RoundTheWall, Exact,
                         testing::Combine(testing::Values("wall-rolling"), testing::Range(3, 9)),
                         nameOf);

// Steps of 2/15 s, of half and of a quarter of that are divided into the same stretches of flight
// here, and so give the same bits: that they agree says nothing of how exact they are.
TEST(ChooseMethod, IsNotDeceivedByStepsThatAreDividedAlike) {
  World start = freeWorld();
  start.tracks.push_back(
      {.keyframes = {{.position = {0, 20, 0}, .strength = 28}}, .softening = 0.5});
  addUnitBall(start, {3, 20, 0}, {0, 0, 1});
  const auto stretch = [&](double dt) {
    start.settings.dt = dt;
    return fieldOf(start).stretch;
  };
  ASSERT_DOUBLE_EQ(stretch(kLongestStep), stretch(kLongestStep / 4));
  const double error = 1e-7;
  const double duration = 2;
  const Choice choice = choiceFor(start, duration, error);
  World chosen = with(start, choice.best.method, choice.best.dt);
  runFor(chosen, stepsOf(duration, choice.best.dt), 1e9);
  World fine = with(start, {"rk4", ContactMethod::Exact, 4}, 2e-5);
  runFor(fine, stepsOf(duration, 2e-5), 1e9);
  EXPECT_LE(length(chosen.balls.position[0] - fine.balls.position[0]), error);
}

TEST(ChooseMethod, ChoosesTheSameEachTime) {
  const World start = makeScene(findScene("well-bounces"));
  const Choice once = choiceFor(start, 6, 1e-6);
  const Choice again = choiceFor(start, 6, 1e-6);
  EXPECT_EQ(once.best.method, again.best.method);
  EXPECT_EQ(once.best.dt, again.best.dt);
  EXPECT_EQ(once.best.work, again.best.work);
}

TEST(ChooseMethod, SaysWhenAWorldIsTooSensitive) {
  const World start = makeScene(findScene("T2"), 50);  // an elastic gas
  const Choice choice = choiceFor(start, 100, 1e-6);
  EXPECT_GT(choice.duration, 0);
  EXPECT_LT(choice.duration, 100);
  EXPECT_NE(choice.whyShorter.find("own sensitivity exceeds it"), std::string::npos)
      << choice.whyShorter;
}

TEST(ChooseMethod, RefusesLessThanRounding) {
  EXPECT_THROW(choiceFor(makeScene(findScene("T1"), 27), 1, 1e-17), Unreachable);
}

/// The best of what lasts: contacts that go by substeps, whose number is chosen, too.
void expectsCheapestBesideLastingContacts(const World& start, double duration, double error) {
  const Choice choice = choiceFor(start, duration, error);
  ASSERT_EQ(choice.duration, duration) << choice.whyShorter;
  World fine = with(start, {"rk4", ContactMethod::Exact, 16}, 1e-4);
  runFor(fine, stepsOf(duration, 1e-4), 1e9);
  const auto errorOf = [&](const World& world) {
    return largestDistance(world.balls.position, fine.balls.position);
  };
  World chosen = with(start, choice.best.method, choice.best.dt);
  runFor(chosen, stepsOf(duration, choice.best.dt), 1e9);
  EXPECT_LE(errorOf(chosen), error);
  const double half = choice.best.work / 2;
  for (const int substeps : {1, 4, 16})
    for (const Integrator& integrator : integrators())
      for (double dt = kLongestStep; dt > kShortestStep; dt /= 2) {
        const std::int64_t steps = stepsOf(duration, dt);
        const TrialMethod method{std::string(integrator.name), ContactMethod::Auto, substeps};
        World world = with(start, method, duration / static_cast<double>(steps));
        if (runFor(world, steps, half) > half) break;
        EXPECT_GT(errorOf(world), error) << name(method) << ' ' << substeps << ", dt = " << dt;
      }
}

TEST(ChooseMethod, BalancesStepsAndSubstepsInAHeap) {
  expectsCheapestBesideLastingContacts(makeScene(findScene("T1"), 27), 0.8, 1e-3);
}

TEST(ChooseMethod, BalancesStepsAndSubstepsOfARollingPair) {
  // A well that repels presses the nearer ball against the other one.
  World start;
  start.settings.elasticity = 0;
  start.tracks.push_back({.keyframes = {{.position = {0, 0.5, 0}, .strength = -1000}}});
  start.settings.substeps = 1;
  addUnitBall(start, {5, 0.5, 0});
  addUnitBall(start, {6, 0.5, 0});
  expectsCheapestBesideLastingContacts(start, 1, 1e-6);
}

}  // namespace
}  // namespace wells
