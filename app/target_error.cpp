#include "target_error.h"

#include <fmt/format.h>

#include <optional>

#include "command_line.h"
#include "errors.h"
#include "values.h"

namespace wells {
namespace {

// m. Below, rounding decides: a coordinate of 40 m has a last place of 7e-15 m, and each of
// thousands of steps rounds.
const Range kErrors = Range::between(1e-11, 1);

std::string row(const TriedMethod& tried, const TriedMethod& best) {
  const bool isChosen = tried.isReached && tried.method == best.method;
  const bool isDearer = tried.work >= best.work;
  return fmt::format("{:26} {:>8} {:>12.6g} {:>12} {:>12.3g}  {}\n", name(tried.method),
                     tried.method.substeps, tried.dt,
                     tried.isReached ? fmt::format("{:.2g}", tried.error) : "-", tried.work,
                     isChosen          ? "chosen"
                     : tried.isReached ? ""
                     : isDearer        ? "not reached, and shorter steps cost more"
                                       : "not reached, and not tried further");
}

}  // namespace

double parseTargetError(const std::string& value) {
  double error = 0;
  parseOption("--target-error", value, fmt::format("a number {}, in m", kErrors.text()),
              [&] { error = parseNumber(value, kErrors); });
  return error;
}

std::string targetErrorHelp() {
  return fmt::format(
      "chooses the cheapest Integrator, ContactMethod, Substeps and Dt with which no ball is "
      "further than this from where it should be, on a short trial of this world, and says why. "
      "Allowed: a number {}, in m",
      kErrors.text());
}

Choice chooseSettings(const TrialWorld& world, double error, double duration, double longestStep,
                      ProgressLine::Shown shown, Settings& settings) {
  const TrialGoal goal{.error = error,
                       .duration = duration,
                       .dt = settings.dt,
                       .method = {settings.integrator, settings.contactMethod, settings.substeps},
                       .longestStep = longestStep};
  Choice choice;
  try {
    std::optional<StatusLine> line;
    if (shown == ProgressLine::Shown::Yes) line.emplace();
    choice = chooseMethod(world, goal, [&](const std::string& what) {
      if (line) line->show("trial for --target-error: " + what);
    });
  } catch (const Unreachable& unreachable) {
    throw UsageError(fmt::format("--target-error {}: {}", formatNumber(error), unreachable.what()));
  }
  settings.dt = choice.best.dt;
  settings.integrator = choice.best.method.integrator;
  settings.contactMethod = choice.best.method.contacts;
  settings.substeps = choice.best.method.substeps;
  return choice;
}

std::string choiceText(const Choice& choice, double error, double duration) {
  std::string text = fmt::format(
      "target error {:g} m, on a trial of {:.6g} s of this world; CPU times are estimated\n"
      "where the balls should be: {}, Dt = {:.3g} s; the last halving moved none by more "
      "than {:.2g} m\n"
      "{:26} {:>8} {:>12} {:>12} {:>12}\n",
      error, choice.duration, name(choice.referenceMethod), choice.referenceDt,
      choice.referenceChange, "method", "substeps", "Dt (s)", "error (m)", "CPU time (s)");
  for (const TriedMethod& tried : choice.tried) text += row(tried, choice.best);
  if (!choice.isComplete) text += "the search ended early: more would cost more than a trial may\n";
  if (choice.duration < duration * (1 - 1e-9))
    text += fmt::format("nothing is promised beyond {:.6g} s: {}\n", choice.duration,
                        choice.whyShorter.empty() ? "a trial is no longer" : choice.whyShorter);
  return text + fmt::format(
                    "the cheapest that reaches it, as lines of a config:\n"
                    "Dt={}\nIntegrator={}\nContactMethod={}\nSubsteps={}\n",
                    formatNumber(choice.best.dt), choice.best.method.integrator,
                    name(choice.best.method.contacts), choice.best.method.substeps);
}

}  // namespace wells
