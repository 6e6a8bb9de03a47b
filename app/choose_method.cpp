#include "choose_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "flight/integrators.h"
#include "trial_reference.h"
#include "world/contact_choice.h"

namespace wells {
namespace {

constexpr double kPilotShare = 1.0 / 64;  // of the trial's work, for one run as the world is now
constexpr int kBisections = 3;            // between a step that is too long and its half: to 9 %
constexpr std::array kSubsteps = {1, 4, 16};

/// s, of a run as the world is now that costs a small part of the trial.
double affordable(Trials& trials, const TrialGoal& goal) {
  trials.say("how much a run costs");
  const auto steps = static_cast<std::int64_t>(std::ceil(goal.duration / goal.dt - 1e-9));
  const TrialRun pilot =
      trials.run(goal.method, {goal.duration, 1}, std::max<std::int64_t>(1, steps),
                 {.work = kPilotShare * kMostTrialWork, .goesOn = {}});
  return pilot.samples.empty() ? static_cast<double>(pilot.steps) * goal.dt : goal.duration;
}

/// Of all candidates the one that was cheapest so far goes on, with steps half as long, until one
/// reaches the error and no other one could for less.
class Search {
 public:
  Search(Trials& trials, const TrialGoal& goal, const Reference& reference)
      : trials_(trials),
        goal_(goal),
        reference_(reference),
        best_{reference.known},
        tried_{best_} {}

  void run() {
    for (auto one = integrators().rbegin(); one != integrators().rend(); ++one)
      for (const ContactMethod contacts : {ContactMethod::Auto, ContactMethod::Substep})
        add({std::string(one->name), contacts, goal_.method.substeps});
    for (;;) {
      std::size_t next = candidates_.size();
      for (std::size_t i = 0; i < candidates_.size(); ++i)
        if (candidates_[i].isOpen &&
            (next == candidates_.size() || candidates_[i].work < candidates_[next].work))
          next = i;
      if (next == candidates_.size()) return;
      advance(next);
    }
  }

  const TriedMethod& best() const { return best_; }
  const std::vector<TriedMethod>& tried() const { return tried_; }

 private:
  struct Candidate {
    TrialMethod method;
    std::int64_t steps = 1;   // in an interval, to be tried next
    std::int64_t failed = 0;  // tried last; 0: none was
    double work = 0;          // s, of a whole run with those
    bool isOpen = true;
  };

  struct Attempt {
    std::int64_t steps = 0;  // in an interval
    double error = 0;        // m, by the time at which it ended
    double work = 0;         // s, of a whole run
    bool isReached = false;
    bool usedSubsteps = false;
    bool isOther = false;  // the engine used another contact method
  };

  void add(const TrialMethod& method) {
    const auto same = std::find_if(candidates_.begin(), candidates_.end(),
                                   [&](const Candidate& c) { return c.method == method; });
    if (same == candidates_.end())
      candidates_.push_back({.method = method, .steps = reference_.fewestSteps});
  }

  /// What a method may be varied in once it is known that it moves balls by substeps.
  void addVariants(const TrialMethod& method) {
    if (method.substeps != goal_.method.substeps) return;
    TrialMethod other = method;
    for (const int substeps : kSubsteps) {
      other.substeps = substeps;
      add(other);
    }
    // Where there is no crowd auto and exact are the same.
    const bool mayCrowd = reference_.samples.front().size() > kCrowd;
    if (method.contacts == ContactMethod::Auto && mayCrowd)
      add({method.integrator, ContactMethod::Exact, method.substeps});
  }

  void advance(std::size_t index) {
    Candidate now = candidates_[index];
    Attempt last = attempt(now.method, now.steps);
    if (last.usedSubsteps && now.failed == 0) addVariants(now.method);
    if (last.isReached) refine(now.method, now.failed, last);
    if (!last.isOther) note(now.method, last);
    now.failed = now.steps;
    now.steps *= 2;
    now.work = last.work;
    now.isOpen = !last.isReached && !last.isOther &&
                 reference_.times.dt(now.steps) >= kShortestStep && trials_.spent() < 1 &&
                 last.work < best_.work;
    candidates_[index] = now;
  }

  /// The longest step between that of `failed` steps (0: none) and that which reached it.
  void refine(const TrialMethod& method, std::int64_t failed, Attempt& reached) {
    for (int i = 0; i < kBisections && failed > 0; ++i) {
      const auto middle = static_cast<std::int64_t>(std::llround(
          std::sqrt(static_cast<double>(failed) * static_cast<double>(reached.steps))));
      if (middle <= failed || middle >= reached.steps) return;
      const Attempt now = attempt(method, middle);
      if (now.isReached)
        reached = now;
      else
        failed = middle;
    }
  }

  Attempt attempt(const TrialMethod& method, std::int64_t steps) {
    trials_.say(fmt::format("{}, dt = {:.3g} s", name(method), reference_.times.dt(steps)));
    Attempt result{.steps = steps};
    const auto isWithin = [&](const Positions& sample, int i) {
      result.error = std::max(result.error,
                              largestDistance(sample, reference_.samples[i]) + reference_.change);
      return result.error <= goal_.error;
    };
    try {
      const TrialRun made =
          trials_.run(method, reference_.times, steps, {.work = mostWork(), .goesOn = isWithin});
      result.work = made.work / static_cast<double>(made.steps) *
                    static_cast<double>(steps * reference_.times.count);
      result.isReached = made.samples.size() == static_cast<std::size_t>(reference_.times.count) &&
                         result.error <= goal_.error;
      result.usedSubsteps = made.usedSubsteps;
      result.isOther = made.contacts != method.contacts;
    } catch (const std::runtime_error&) {  // more elastic impacts than the world allows in a step
    }
    return result;
  }

  void note(const TrialMethod& method, const Attempt& attempt) {
    const TriedMethod tried{method, reference_.times.dt(attempt.steps), attempt.error, attempt.work,
                            attempt.isReached};
    if (tried.isReached && tried.work < best_.work) best_ = tried;
    const auto same = std::find_if(tried_.begin(), tried_.end(), [&](const TriedMethod& other) {
      return other.method.integrator == method.integrator &&
             other.method.contacts == method.contacts;
    });
    if (same == tried_.end())
      tried_.push_back(tried);
    else if (!same->isReached || (tried.isReached && tried.work < same->work))
      *same = tried;
  }

  /// s; what the next run may cost to be of use: between its step and twice that, which was too
  /// long, there may be one that costs half.
  double mostWork() const { return std::min(2 * best_.work, trials_.workLeft()); }

  Trials& trials_;
  const TrialGoal& goal_;
  const Reference& reference_;
  std::vector<Candidate> candidates_;
  TriedMethod best_;  // at first one of the reference's runs
  std::vector<TriedMethod> tried_;
};

}  // namespace

Choice chooseMethod(const TrialWorld& world, const TrialGoal& goal,
                    const std::function<void(const std::string&)>& progress) {
  Trials trials(world, progress);
  const Reference reference = findReference(trials, goal, affordable(trials, goal));
  Search search(trials, goal, reference);
  search.run();
  return {.best = search.best(),
          .duration = reference.times.duration(),
          .whyShorter = reference.whyShorter,
          .referenceMethod = reference.method,
          .referenceDt = reference.dt,
          .referenceChange = reference.change,
          .tried = search.tried(),
          .isComplete = trials.spent() < 1};
}

}  // namespace wells
