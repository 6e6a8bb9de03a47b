// The stress cases with our engine: no case loses a ball, makes energy in contacts, infects other
// balls or runs without end. The worlds and what must hold in them: scenes/stress_cases.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "app/stress_run.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

// No case takes more than a few seconds; a step without end would run into CTest's limit.
constexpr double kMostTime = 60;  // s

// Sums over some thousand steps of balls and impacts, each rounded to 1e-16.
constexpr double kRounding = 1e-9;

/// As GoogleTest names tests: without '-'.
std::vector<std::string> stressCaseNames() {
  std::vector<std::string> names;
  for (const StressCase& stress : stressCases()) {
    names.emplace_back(stress.name);
    std::ranges::replace(names.back(), '-', '_');
  }
  return names;
}

const StressCase& caseOf(std::string name) {
  std::ranges::replace(name, '_', '-');
  return findStressCase(name);
}

class Stress : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

// The substeps look at a ball four times a step: at 10^4 m/s it covers 250 m from one look to the
// next, so that what it hits on the way is chance. `auto` never leaves fast balls to them.
bool isPromised(const StressCase& stress, ContactMethod method) {
  return method != ContactMethod::Substep || !stress.name.starts_with("fast-");
}

TEST_P(Stress, IsHeld) {
  const StressCase& stress = caseOf(std::get<0>(GetParam()));
  const ContactMethod method = *contactMethod(std::get<1>(GetParam()));
  if (!isPromised(stress, method)) GTEST_SKIP() << "not promised";
  const auto setMethod = [&](World& world) { world.settings.contactMethod = method; };
  const StressResult result = runStress(stress, makeSimulation, kMostTime, setMethod);
  EXPECT_EQ(verdict(stress, result), "held")
      << "gain " << result.gain << " J, relative " << result.relativeGain << ", lost "
      << result.lost << ", not finite " << result.notFinite
      << (result.gaveUp.empty() ? "" : "\n" + result.gaveUp.front());
  // The verdict's bound is as wide as single precision needs it.
  if (stress.energy == EnergyPromise::NeverRises) {
    EXPECT_LE(result.relativeGain, kRounding);
  }
  EXPECT_TRUE(result.isNamed) << "quarantined: other balls than those that started not finite";
  EXPECT_EQ(result.counts.latePairs, 0);
}

INSTANTIATE_TEST_SUITE_P(Ours, Stress,
                         testing::Combine(testing::ValuesIn(stressCaseNames()),
                                          testing::Values("auto", "exact", "substep")),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_by_" + std::get<1>(test.param);
                         });

/// The books of a run, held against measures that know nothing of them.
class BooksWatch {
 public:
  void see(const Stepper& stepper, const World& world) {
    const Books& now = *stepper.books();
    const Measures measures = measure(world);
    if (world.step == 0) {
      *this = {};
      start_ = measures.energy();
    }
    scale_ = std::max({scale_, measures.kineticEnergy, std::abs(measures.potentialEnergy)});
    gap_ = std::max(gap_, std::abs(measures.energy() - start_ - now.energy()) / scale_);
    worstGap = std::max(worstGap, gap_);
    contacts = std::max(contacts, (now.contacts - before_.contacts) / scale_);
    friction = std::max(friction, (now.friction - before_.friction) / scale_);
    before_ = now;
  }

  // Worst of all steps so far, in parts of the largest kinetic or potential energy until then.
  double worstGap = 0;  // between what the books say and what is there
  double contacts = 0;  // energy that contacts added
  double friction = 0;

 private:
  double start_ = 0;  // J
  double scale_ = 1;  // J
  double gap_ = 0;
  Books before_;
};

class StressBooks : public testing::TestWithParam<std::string> {};

// Wells that move, pushing out and the integrator's residual are booked apart; so whatever they do,
// contacts and friction must never add anything. Booked impulse by impulse: 1e-12 is what rounding
// leaves of some thousand of them a step.
TEST_P(StressBooks, CloseAndContactsNeverAdd) {
  const auto make = [] {
    auto stepper = makeSimulation();
    stepper->openBooks();
    return stepper;
  };
  BooksWatch watch;
  runStress(caseOf(GetParam()), make, kMostTime, {},
            [&](const Stepper& stepper, const World& world) { watch.see(stepper, world); });
  EXPECT_LE(watch.worstGap, kRounding);
  EXPECT_LE(watch.contacts, 1e-12);
  EXPECT_LE(watch.friction, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Ours, StressBooks, testing::ValuesIn(stressCaseNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wells
