#include "trial_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contacts/held_motion.h"
#include "flight/integrators.h"
#include "forces/field.h"
#include "world/contact_choice.h"

namespace wells {
namespace {

constexpr int kMostSamples = 16;
constexpr double kShare = 0.5;      // of what is left of the trial
constexpr double kTolerance = 0.5;  // of the error
constexpr double kFarLess = 16;     // by this the highest order shrinks an error at each halving
constexpr double kStalled = 0.7;    // of the change by the halving before: no convergence
constexpr int kMostStalls = 4;      // while no more samples agree
constexpr double kNudge = 0x1p-50;  // of the largest coordinate: a few units in its last place

const Integrator& highestOrder() {
  // Of several the last: the table has the more exact one there.
  const Integrator* best = &integrators().front();
  for (const Integrator& one : integrators())
    if (one.order >= best->order) best = &one;
  return *best;
}

/// Where no crowd is possible auto is as exact, and never stops a run.
ContactMethod mostExact(const World& world) {
  return world.balls.size() <= kCrowd ? ContactMethod::Auto : ContactMethod::Exact;
}

double largestCoordinate(const Positions& positions) {
  double largest = 0;
  for (const Vec3& p : positions)
    if (isFinite(p))
      largest = std::max({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return largest;
}

/// s. In longer steps a ball that runs round the wall moves in pieces of always the same length,
/// and halving the step tells nothing. (Where no force acts, pieces of any length are exact.)
double undividedStep(const World& world) {
  const Settings& settings = world.settings;
  if (settings.friction == 0 && squaredLength(settings.gravity) == 0 && world.tracks.empty())
    return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    const double speed = length(world.balls.velocity[i]);
    if (isFinite(world.balls.state(i)) && speed > 0)
      least = std::min(least, kLongestArc * (world.arena.radius - world.balls.radius[i]) / speed);
  }
  return least;
}

class Convergence {
 public:
  Convergence(Trials& trials, const TrialGoal& goal, double duration)
      : trials_(trials),
        goal_(goal),
        method_{std::string(highestOrder().name), mostExact(trials.start(goal.dt)),
                goal.method.substeps} {
    times_.count = static_cast<int>(
        std::clamp(std::ceil(duration / goal.longestStep - 1e-9), 1.0, double{kMostSamples}));
    times_.interval = duration / times_.count;
    fewestSteps_ = static_cast<std::int64_t>(std::ceil(times_.interval / goal.longestStep - 1e-9));
  }

  /// Halves the steps until twice in a row no position changes by more than the tolerance, or once
  /// by far less.
  void run() {
    const double tolerance = kTolerance * goal_.error;
    const double undivided = undividedStep(trials_.start(goal_.dt));
    const double before = trials_.spent();
    const double most = before + kShare * (1 - before);
    const double longest = undividedStep(trials_.start(goal_.dt));
    runWith(
        std::max(fewestSteps_, static_cast<std::int64_t>(std::ceil(times_.interval / longest))));
    double change = std::numeric_limits<double>::infinity();  // m, where runs first disagree
    int agreedBefore = 0;
    int mostAgreed = 0;
    int stalls = 0;
    while (agreed_ < times_.count && stalls < kMostStalls) {
      const std::int64_t next = halved(last().steps);
      const double expected =
          last().run.work * static_cast<double>(next) / static_cast<double>(last().steps);
      if (trials_.spent() + expected / kMostTrialWork > most || times_.dt(next) < kShortestStep)
        return;
      const bool tells = times_.dt(last().steps) <= undivided;
      runWith(next);
      if (!tells) continue;
      const int agreed = agreement(tolerance);
      agreed_ = std::max(std::min(agreedBefore, agreed), agreement(tolerance / kFarLess));
      const double now = agreed_ < times_.count ? changeAt(agreed_) : 0;
      if (agreed > mostAgreed)
        stalls = 0;
      else if (now > kStalled * change)
        ++stalls;
      mostAgreed = std::max(mostAgreed, agreed);
      isStalled_ = stalls == kMostStalls;
      change = now;
      agreedBefore = agreed;
    }
  }

  /// Samples of which it is known where the balls should be, from the first on.
  int agreed() const { return agreed_; }
  const TrialTimes& times() const { return times_; }

  /// Why there are no more of them.
  std::string reason() {
    if (made_.size() < 2) return "more of this world costs more than a trial may";
    trials_.say("the world's own sensitivity");
    const Made& before = made_.end()[-2];
    const Positions& there = before.run.samples[agreed_];
    const double until = times_.interval * (agreed_ + 1);  // s
    const double nudge = kNudge * largestCoordinate(there);
    const TrialRun nudged = trials_.run(method_, times_, before.steps, {}, nudge);
    const double apart = largestDistance(nudged.samples[agreed_], there);
    const double change = changeAt(agreed_);
    if (apart > kTolerance * goal_.error)
      return fmt::format(
          "by {:.3g} s the world's own sensitivity exceeds it: balls that start {:.0e} m elsewhere "
          "end {:.2g} m elsewhere",
          until, nudge, apart);
    if (isStalled_)
      return fmt::format(
          "by {:.3g} s the world's own sensitivity exceeds it: it multiplies a change at the start "
          "by {:.2g}, and rounding at each step, which shorter steps do not lessen, moves a ball "
          "by "
          "{:.2g} m",
          until, apart / nudge, change);
    return fmt::format(
        "by {:.3g} s it is not sure where the balls should be: halving steps of {:.2g} s still "
        "moves one by {:.2g} m, and going on costs more than a trial may",
        until, times_.dt(before.steps), change);
  }

  /// With the samples that agreed.
  Reference reference(const std::string& whyShorter) const {
    Reference result{.times = {times_.interval, agreed_},
                     .fewestSteps = fewestSteps_,
                     .samples = last().run.samples,
                     .method = method_,
                     .dt = times_.dt(last().steps),
                     .change = 0,
                     .known = {},
                     .whyShorter = whyShorter};
    for (int i = 0; i < agreed_; ++i) result.change = std::max(result.change, changeAt(i));
    for (auto made = made_.rbegin() + 1; made != made_.rend(); ++made) {
      double error = result.change;
      for (int i = 0; i < agreed_; ++i)
        error = std::max(error,
                         result.change + largestDistance(made->run.samples[i], result.samples[i]));
      const double work = made->run.work * agreed_ / times_.count;
      if (error <= goal_.error && (result.known.work == 0 || work < result.known.work))
        result.known = {method_, times_.dt(made->steps), error, work, true};
    }
    return result;
  }

 private:
  struct Made {
    std::int64_t steps = 0;  // in an interval
    TrialRun run;
  };
  const Made& last() const { return made_.back(); }

  void runWith(std::int64_t steps) {
    trials_.say(fmt::format("reference, {}, dt = {:.3g} s", name(method_), times_.dt(steps)));
    try {
      made_.push_back({steps, trials_.run(method_, times_, steps, {})});
    } catch (const std::runtime_error& error) {  // more elastic impacts than a step may have
      throw Unreachable(error.what());
    }
  }

  /// s, of flight in one piece.
  double stretch(std::int64_t steps) const {
    const double dt = times_.dt(steps);
    return dt / static_cast<double>(fieldOf(trials_.start(dt)).stretches);
  }

  /// The next number of steps whose flight is in pieces half as long. (Beside sharp wells steps of
  /// different length may be divided into the same pieces, and give the same result.)
  std::int64_t halved(std::int64_t steps) const {
    const double half = 0.51 * stretch(steps);
    do steps *= 2;
    while (stretch(steps) > half && times_.dt(steps) > kShortestStep);
    return steps;
  }

  /// m, by the last halving.
  double changeAt(int sample) const {
    return largestDistance(made_.end()[-2].run.samples[sample], last().run.samples[sample]);
  }

  /// How many of the first samples the last halving changed by no more than `tolerance` (m).
  int agreement(double tolerance) const {
    for (int i = 0; i < times_.count; ++i)
      if (!(changeAt(i) <= tolerance)) return i;
    return times_.count;
  }

  Trials& trials_;
  const TrialGoal& goal_;
  TrialMethod method_;
  TrialTimes times_;
  std::int64_t fewestSteps_ = 1;  // in an interval
  std::vector<Made> made_;        // each with steps half as long as the one before
  int agreed_ = 0;
  bool isStalled_ = false;  // halving has stopped helping
};

}  // namespace

Reference findReference(Trials& trials, const TrialGoal& goal, double duration) {
  std::string why;
  if (duration < goal.duration) why = "more of this world costs more than a trial may";
  for (;;) {
    Convergence convergence(trials, goal, duration);
    convergence.run();
    if (convergence.agreed() < convergence.times().count) why = convergence.reason();
    if (convergence.agreed() > 0) return convergence.reference(why);
    if (convergence.times().count == 1) throw Unreachable(why + "; allowed: a larger error");
    duration = convergence.times().interval;
  }
}

}  // namespace wells
