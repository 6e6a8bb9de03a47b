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

// Accumulated impulses do not keep the energy of elastic impacts at several contacts of one ball at
// the same time, which is why `auto` never leaves elastic balls without friction to the substeps.
double mostGain(const StressCase& stress, ContactMethod method) {
  const bool isCluster = stress.name == "touching-lattice";
  return isCluster && method == ContactMethod::Substep ? 1e-6 : kRounding;
}

TEST_P(Stress, IsHeld) {
  const StressCase& stress = caseOf(std::get<0>(GetParam()));
  const ContactMethod method = *contactMethod(std::get<1>(GetParam()));
  if (!isPromised(stress, method)) GTEST_SKIP() << "not promised";
  const auto setMethod = [&](World& world) { world.settings.contactMethod = method; };
  const StressResult result = runStress(
      stress, [] { return makeSimulation(); }, kMostTime, setMethod);
  EXPECT_EQ(verdict(stress, result), "held")
      << "gain " << result.gain << " J, relative " << result.relativeGain << ", lost "
      << result.lost << ", not finite " << result.notFinite
      << (result.gaveUp.empty() ? "" : "\n" + result.gaveUp.front());
  // The verdict's bound is as wide as single precision needs it.
  if (stress.energy == EnergyPromise::NeverRises) {
    EXPECT_LE(result.relativeGain, mostGain(stress, method));
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
    both = std::max(both,
                    (now.contacts + now.friction - before_.contacts - before_.friction) / scale_);
    before_ = now;
  }

  // Worst of all steps so far, in parts of the largest kinetic or potential energy until then.
  double worstGap = 0;  // between what the books say and what is there
  double contacts = 0;  // energy that contacts added
  double both = 0;      // that contacts and friction together added

 private:
  double start_ = 0;  // J
  double scale_ = 1;  // J
  double gap_ = 0;
  Books before_;
};

class StressBooks : public testing::TestWithParam<std::string> {};

/// What contacts may add in a step, in parts of the largest energy so far. Booked impulse by
/// impulse, rounding leaves 1e-12 of some thousand of them. Where substeps resolve the world badly,
/// they may add a little:
///  - four passes leave impulses unfinished between radii 1 : 100, and among 27 balls in one point;
///  - a shift by the force of contact counts the pull as constant over a substep, which it is not
///    beside a well of 0.01 m, and not for substeps of 0.25 s (dt = 1 s).
double mostAdded(const std::string& name) {
  if (name == "radius_ratio" || name == "overlap_clump" || name == "sharp_well") return 1e-4;
  return name == "any_step" ? 1e-3 : 1e-12;
}

// Wells that move, pushing out and the integrator's residual are booked apart; so whatever they do,
// contacts must never add anything, nor contacts and friction together. (In a heap that is not
// solved to the end, friction alone may: what one contact took from a slip another has given.)
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
  EXPECT_LE(watch.contacts, mostAdded(GetParam()));
  EXPECT_LE(watch.both, mostAdded(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Ours, StressBooks, testing::ValuesIn(stressCaseNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wells
