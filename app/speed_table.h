// What the benchmark "speed" measured, as text, CSV and a gnuplot script. Numbers in, text out.
#pragma once

#include <span>
#include <string>

#include "speed_run.h"

namespace wells {

/// One scene, as it is printed.
std::string speedText(const SpeedResult& result);

/// All scenes, a row for each method.
std::string speedCsv(std::span<const SpeedResult> results);

/// Draws speed.png from speed.csv: time of a step of T1 against the number of balls, of several
/// tuned settings of a scene the first. Empty where nothing of T1 was measured.
std::string speedScript(std::span<const SpeedResult> results);

}  // namespace wells
