// Where the time of a step of ours goes, by stage (state/stage_clock.h).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "state/stage_clock.h"
#include "state/stepper.h"

namespace wells {

struct StageRow {
  std::string scene;
  std::string method;
  std::int64_t steps = 0;
  StageTimes mean{};    // s, of a step
  double stepTime = 0;  // s, the mean around the calls
};

/// Runs `world` for so many steps. The engine's clock is opened. Throws RunError where it has none.
StageRow runStages(std::string_view scene, std::string_view method, Stepper& stepper, World world,
                   std::int64_t steps);

std::string stageText(std::span<const StageRow> rows);
std::string stageCsv(std::span<const StageRow> rows);

}  // namespace wells
