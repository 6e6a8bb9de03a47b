// `--target-error`: what peer and bench do with chooseMethod. Parses, shows progress, says what was
// chosen and why.
#pragma once

#include <string>

#include "choose_method.h"
#include "config.h"
#include "progress.h"

namespace wells {

/// m. Throws UsageError.
double parseTargetError(const std::string& value);

/// What both --help texts say of the option.
std::string targetErrorHelp();

/// Chooses for a run of `duration` (s) of a world that now has `settings`, and puts the choice into
/// them. Throws UsageError where `error` (m) cannot be reached.
Choice chooseSettings(const TrialWorld& world, double error, double duration, double longestStep,
                      ProgressLine::Shown shown, Settings& settings);

/// What was tried and chosen, and the config's lines for it; several lines. `duration`: s, of the
/// run.
std::string choiceText(const Choice& choice, double error, double duration);

}  // namespace wells
