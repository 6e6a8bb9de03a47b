#include "choose_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "flight/integrators.h"
#include "forces/field.h"
#include "values.h"

namespace wells {
namespace {

constexpr int kMostSamples = 16;
constexpr double kPilotShare = 1.0 / 64;     // of the trial's work, for one run as the world is now
constexpr double kReferenceShare = 0.5;      // of the trial's work
constexpr double kReferenceTolerance = 0.5;  // of the error
constexpr double kFarLess = 16;              // the order's factor, for one halving
constexpr double kStalled = 0.7;             // of the change by the halving before: no convergence
constexpr int kMostStalls = 4;               // in a row
constexpr double kNudge = 0x1p-50;  // of the largest coordinate: a few units in its last place
constexpr int kBisections = 3;      // between a step that is too long and its half: to 9 %
constexpr std::array kSubsteps = {1, 4, 16};

const Integrator& highestOrder() {
  const auto all = integrators();
  // The last of the highest: the table has the more exact one there.
  const Integrator* best = &all.front();
  for (const Integrator& one : all)
    if (one.order >= best->order) best = &one;
  return *best;
}

class Trial {
 public:
  Trial(const TrialWorld& world, const TrialGoal& goal,
        const std::function<void(const std::string&)>& progress)
      : world_(world), goal_(goal), progress_(progress) {}

  Choice choose() {
    findTimes();
    findReference();
    search();
    if (!best_)
      throw Unreachable(fmt::format(
          "no method reaches it in {:.3g} s of this world with what a trial may cost ({} s of "
          "estimated CPU time); allowed: a larger error",
          choice_.duration, kMostTrialWork));
    choice_.best = *best_;
    return choice_;
  }

 private:
  // ---- how long

  void findTimes() {
    progress_("how much a run costs");
    const auto steps = static_cast<std::int64_t>(std::ceil(goal_.duration / goal_.dt - 1e-9));
    const TrialRun pilot = run(goal_.method, {goal_.duration, 1}, std::max<std::int64_t>(1, steps),
                               {.work = kPilotShare * kMostTrialWork, .goesOn = {}});
    choice_.duration = goal_.duration;
    if (pilot.samples.empty()) {
      choice_.duration = static_cast<double>(pilot.steps) * goal_.dt;
      choice_.whyShorter = "more of this world would cost too much";
    }
    times_.count = static_cast<int>(std::clamp(
        std::ceil(choice_.duration / goal_.longestStep - 1e-9), 1.0, double{kMostSamples}));
    times_.interval = choice_.duration / times_.count;
    fewestSteps_ = static_cast<std::int64_t>(std::ceil(times_.interval / goal_.longestStep - 1e-9));
  }

  // ---- where the balls should be

  /// s, of flight in one piece.
  double stretch(std::int64_t stepsPerInterval) const {
    const TrialStart start = world_(dtOf(stepsPerInterval));
    return fieldOf(start.world).wells.empty() ? start.world.settings.dt
                                              : fieldOf(start.world).stretch;
  }

  /// The next number of steps whose flight is in pieces half as long. (Beside sharp wells steps of
  /// different length may have the same pieces, and the same result.)
  std::int64_t halved(std::int64_t stepsPerInterval) const {
    const double half = 0.51 * stretch(stepsPerInterval);
    do stepsPerInterval *= 2;
    while (stretch(stepsPerInterval) > half && dtOf(stepsPerInterval) > kShortestStep);
    return stepsPerInterval;
  }

  /// Two halvings that change nothing by more than the tolerance, or one by far less.
  void findReference() {
    const TrialMethod method{std::string(highestOrder().name), ContactMethod::Exact,
                             goal_.method.substeps};
    const double tolerance = kReferenceTolerance * goal_.error;
    std::int64_t steps = fewestSteps_;
    TrialRun last = referenceRun(method, steps);
    TrialRun before;
    std::int64_t coarser = steps;
    double change = std::numeric_limits<double>::infinity();  // m, where runs first disagreed
    int agreedBefore = 0;
    int agreed = 0;
    for (int stalls = 0; agreed < times_.count && stalls < kMostStalls;) {
      const std::int64_t next = halved(steps);
      const double expected = last.work * static_cast<double>(next) / static_cast<double>(steps);
      if (work_ + expected > kReferenceShare * kMostTrialWork || dtOf(next) < kShortestStep) break;
      before = std::move(last);
      coarser = std::exchange(steps, next);
      last = referenceRun(method, steps);
      const int now = agreement(before, last, tolerance);
      agreed = std::max(std::min(agreedBefore, now), agreement(before, last, tolerance / kFarLess));
      const double changeNow =
          agreed < times_.count ? largestDistance(before.samples[agreed], last.samples[agreed]) : 0;
      stalls = now <= agreedBefore && changeNow > kStalled * change ? stalls + 1 : 0;
      change = changeNow;
      agreedBefore = now;
    }
    choice_.referenceIntegrator = method.integrator;
    choice_.referenceDt = dtOf(steps);
    if (agreed < times_.count) shorten(method, coarser, before, last, agreed);
    for (int i = 0; i < times_.count; ++i)
      choice_.referenceChange =
          std::max(choice_.referenceChange, largestDistance(before.samples[i], last.samples[i]));
    reference_ = std::move(last.samples);
  }

  TrialRun referenceRun(const TrialMethod& method, std::int64_t steps) {
    progress_(fmt::format("reference, {}, dt = {:.3g} s", name(method), dtOf(steps)));
    return run(method, times_, steps, {});
  }

  /// In how many of the first samples two runs are within `tolerance` (m).
  int agreement(const TrialRun& a, const TrialRun& b, double tolerance) const {
    for (int i = 0; i < times_.count; ++i)
      if (!(largestDistance(a.samples[i], b.samples[i]) <= tolerance)) return i;
    return times_.count;
  }

  /// To the first `agreed` samples; says why.
  void shorten(const TrialMethod& method, std::int64_t steps, const TrialRun& before,
               const TrialRun& last, int agreed) {
    const double until = times_.interval * (agreed + 1);  // s
    if (before.samples.empty())
      throw Unreachable(
          "even a single run of this world, with the longest steps, costs more than a trial may; "
          "allowed: a smaller world");
    progress_("the world's own sensitivity");
    double largest = 0;  // m
    for (const Vec3& p : before.samples[agreed])
      if (isFinite(p))
        largest = std::max({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    const double nudge = kNudge * largest;
    const TrialRun nudged = run(method, times_, steps, {}, nudge);
    const double apart = largestDistance(nudged.samples[agreed], before.samples[agreed]);
    const std::string why =
        apart > kReferenceTolerance * goal_.error
            ? fmt::format(
                  "by {:.3g} s the world's own sensitivity exceeds it: balls that start "
                  "{:.0e} m elsewhere end {:.2g} m elsewhere",
                  until, nudge, apart)
            : fmt::format(
                  "by {:.3g} s it is not sure where the balls should be: halving steps of "
                  "{:.2g} s still moves one by {:.2g} m, and going on costs more than a "
                  "trial may",
                  until, dtOf(steps),
                  largestDistance(before.samples[agreed], last.samples[agreed]));
    if (agreed == 0) throw Unreachable(why + "; allowed: a larger error");
    choice_.whyShorter = why;
    times_.count = agreed;
    choice_.duration = times_.interval * agreed;
  }

  // ---- the search: the candidate that is cheapest so far goes on, with steps half as long

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

  void search() {
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

  void add(const TrialMethod& method) {
    const auto same = std::find_if(candidates_.begin(), candidates_.end(),
                                   [&](const Candidate& c) { return c.method == method; });
    if (same == candidates_.end()) candidates_.push_back({method, fewestSteps_});
  }

  /// What a method may be varied in once it is known that it moves balls by substeps.
  void addVariants(const TrialMethod& method) {
    if (method.substeps != goal_.method.substeps) return;
    TrialMethod other = method;
    for (const int substeps : kSubsteps) {
      other.substeps = substeps;
      add(other);
    }
    // Where nothing goes by substeps, auto and exact are the same.
    if (method.contacts == ContactMethod::Auto)
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
    now.isOpen = !last.isReached && !last.isOther && dtOf(now.steps) >= kShortestStep &&
                 work_ < kMostTrialWork && !(best_ && last.work >= best_->work);
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
    progress_(fmt::format("{}, dt = {:.3g} s", name(method), dtOf(steps)));
    Attempt result{.steps = steps};
    const auto isWithin = [&](const Positions& sample, int i) {
      result.error =
          std::max(result.error, largestDistance(sample, reference_[i]) + choice_.referenceChange);
      return result.error <= goal_.error;
    };
    try {
      const TrialRun made = run(method, times_, steps, {.work = mostWork(), .goesOn = isWithin});
      result.work =
          made.work / static_cast<double>(made.steps) * static_cast<double>(steps * times_.count);
      result.isReached = made.steps == steps * times_.count && result.error <= goal_.error &&
                         made.work <= mostWork();
      result.usedSubsteps = made.usedSubsteps;
      result.isOther = made.contacts != method.contacts;
    } catch (const std::runtime_error&) {  // more elastic impacts than the world allows in a step
    }
    return result;
  }

  void note(const TrialMethod& method, const Attempt& attempt) {
    const TriedMethod tried{method, dtOf(attempt.steps), attempt.error, attempt.work,
                            attempt.isReached};
    if (tried.isReached && (!best_ || tried.work < best_->work)) best_ = tried;
    const auto same =
        std::find_if(choice_.tried.begin(), choice_.tried.end(), [&](const TriedMethod& other) {
          return other.method.integrator == method.integrator &&
                 other.method.contacts == method.contacts;
        });
    if (same == choice_.tried.end())
      choice_.tried.push_back(tried);
    else if (!same->isReached || (tried.isReached && tried.work < same->work))
      *same = tried;
  }

  /// s; what the next run may cost to be of use: between its step and twice that, which was too
  /// long, there may be one that costs half.
  double mostWork() const {
    const double left = kMostTrialWork - work_;
    return best_ ? std::min(2 * best_->work, left) : left;
  }

  TrialRun run(const TrialMethod& method, const TrialTimes& times, std::int64_t steps,
               const TrialStop& stop, double nudge = 0) {
    TrialRun result = runTrial(world_, method, times, steps, stop, nudge);
    work_ += result.work;
    if (work_ > kMostTrialWork) choice_.isComplete = false;
    return result;
  }

  double dtOf(std::int64_t stepsPerInterval) const {
    return times_.interval / static_cast<double>(stepsPerInterval);
  }

  const TrialWorld& world_;
  const TrialGoal& goal_;
  const std::function<void(const std::string&)>& progress_;
  double work_ = 0;  // s, of all runs
  TrialTimes times_;
  std::int64_t fewestSteps_ = 1;  // in an interval
  std::vector<Positions> reference_;
  std::vector<Candidate> candidates_;
  std::optional<TriedMethod> best_;
  Choice choice_;
};

}  // namespace

Choice chooseMethod(const TrialWorld& world, const TrialGoal& goal,
                    const std::function<void(const std::string&)>& progress) {
  return Trial(world, goal, progress).choose();
}

std::string name(const TrialMethod& method) {
  return fmt::format("{} {}", method.integrator, name(method.contacts));
}

}  // namespace wells
