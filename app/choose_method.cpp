#include "choose_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "flight/integrators.h"
#include "forces/field.h"
#include "values.h"

namespace wells {
namespace {

constexpr int kMostSamples = 16;
constexpr double kPilotShare = 1.0 / 64;  // of the trial's work, for one run as the world is now
constexpr double kReferenceShare = 0.5;   // of the trial's work
constexpr double kReferenceTolerance = 0.25;  // of the error
constexpr double kNudge = 0x1p-50;  // of the largest coordinate: a few units in its last place
constexpr int kBisections = 3;      // between a step that is too long and its half: to 9 %
constexpr std::array kSubsteps = {1, 2, 4, 8, 16, 32};

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

  void findReference() {
    const TrialMethod method{std::string(highestOrder().name), ContactMethod::Exact,
                             goal_.method.substeps};
    const double tolerance = kReferenceTolerance * goal_.error;
    std::int64_t steps = fewestSteps_;
    TrialRun last = referenceRun(method, steps);
    int agreedBefore = 0;
    int agreed = 0;  // samples over which the last three runs do
    std::int64_t coarser = steps;
    TrialRun before;
    double cost = last.work;
    while (agreed < times_.count) {
      const std::int64_t next = halved(steps);
      const double expected = last.work * static_cast<double>(next) / static_cast<double>(steps);
      if (expected > kReferenceShare * kMostTrialWork - cost || dtOf(next) < kShortestStep) break;
      before = std::move(last);
      coarser = steps;
      steps = next;
      last = referenceRun(method, steps);
      cost += last.work;
      const int now = agreement(before, last, tolerance);
      agreed = std::min(agreedBefore, now);
      agreedBefore = now;
    }
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
                  "by {:.3g} s steps of {:.2g} s and of half of that still end {:.2g} m "
                  "apart, and shorter ones would cost more than a trial may",
                  until, dtOf(steps),
                  largestDistance(before.samples[agreed], last.samples[agreed]));
    if (agreed == 0) throw Unreachable(why + "; allowed: a larger error");
    choice_.whyShorter = why;
    times_.count = agreed;
    choice_.duration = times_.interval * agreed;
  }

  // ---- the search

  void search() {
    for (const ContactMethod contacts :
         {ContactMethod::Auto, ContactMethod::Exact, ContactMethod::Substep})
      for (auto one = integrators().rbegin(); one != integrators().rend(); ++one)
        tryMethod({std::string(one->name), contacts, goal_.method.substeps});
  }

  void tryMethod(const TrialMethod& method) {
    // Exact differs from auto only where auto moved a crowd by substeps.
    if (method.contacts == ContactMethod::Exact && !needsExact(method)) return;
    const std::optional<bool> usesSubsteps = tryRung(method);
    if (!usesSubsteps) return;
    if (!*usesSubsteps) return;
    for (const int substeps : kSubsteps) {
      TrialMethod other = method;
      other.substeps = substeps;
      if (other != method) tryRung(other);
    }
  }

  bool needsExact(const TrialMethod& method) const {
    return std::find(autoInSubsteps_.begin(), autoInSubsteps_.end(), method.integrator) !=
           autoInSubsteps_.end();
  }

  struct Attempt {
    std::int64_t steps = 0;  // in an interval
    double error = 0;        // m
    TrialRun run;
    bool isReached = false;
  };

  /// Ever shorter steps, until the error is reached or the cost is that of the best. Whether balls
  /// went by substeps; nothing if the method is another one's.
  std::optional<bool> tryRung(const TrialMethod& method) {
    bool usesSubsteps = false;
    Attempt last;
    for (std::int64_t steps = fewestSteps_; dtOf(steps) >= kShortestStep; steps *= 2) {
      Attempt now = attempt(method, steps);
      if (now.run.contacts != method.contacts) return {};
      usesSubsteps |= now.run.usedSubsteps;
      const bool isTooDear = now.run.work > mostWork();
      if (!isTooDear || last.steps == 0) {
        const std::int64_t failed = last.steps;
        last = std::move(now);
        if (last.isReached) refine(method, failed, last);
      }
      if (last.isReached || isTooDear) break;
    }
    note(method, last);
    if (method.contacts == ContactMethod::Auto && usesSubsteps)
      autoInSubsteps_.push_back(method.integrator);
    return usesSubsteps;
  }

  /// The longest step between that of `failed` steps (0: none) and `reached`.
  void refine(const TrialMethod& method, std::int64_t failed, Attempt& reached) {
    for (int i = 0; i < kBisections && failed > 0; ++i) {
      const auto middle = static_cast<std::int64_t>(std::llround(
          std::sqrt(static_cast<double>(failed) * static_cast<double>(reached.steps))));
      if (middle <= failed || middle >= reached.steps) return;
      Attempt now = attempt(method, middle);
      if (now.isReached)
        reached = std::move(now);
      else
        failed = middle;
    }
  }

  Attempt attempt(const TrialMethod& method, std::int64_t steps) {
    progress_(fmt::format("{}, dt = {:.3g} s", name(method), dtOf(steps)));
    Attempt result{.steps = steps, .error = 0, .run = {}, .isReached = false};
    const auto isWithin = [&](const Positions& sample, int i) {
      result.error =
          std::max(result.error, largestDistance(sample, reference_[i]) + choice_.referenceChange);
      return result.error <= goal_.error;
    };
    try {
      result.run = run(method, times_, steps, {.work = mostWork(), .goesOn = isWithin});
    } catch (const std::runtime_error&) {  // more elastic impacts than the world allows in a step
      return result;
    }
    result.isReached = result.error <= goal_.error &&
                       result.run.samples.size() == static_cast<std::size_t>(times_.count);
    return result;
  }

  void note(const TrialMethod& method, const Attempt& attempt) {
    const TriedMethod tried{method, dtOf(attempt.steps), attempt.error, attempt.run.work,
                            attempt.isReached};
    if (tried.isReached && (!best_ || tried.work < best_->work)) best_ = tried;
    const auto same =
        std::find_if(choice_.tried.begin(), choice_.tried.end(), [&](const TriedMethod& other) {
          return other.method.integrator == method.integrator &&
                 other.method.contacts == method.contacts;
        });
    if (same == choice_.tried.end())
      choice_.tried.push_back(tried);
    else if (tried.isReached && (!same->isReached || tried.work < same->work))
      *same = tried;
  }

  /// s; what the next run may cost to be of use.
  double mostWork() const {
    const double left = kMostTrialWork - work_;
    return best_ ? std::min(best_->work, left) : left;
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
  std::vector<std::string> autoInSubsteps_;  // integrators
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
