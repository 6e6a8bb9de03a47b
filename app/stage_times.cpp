#include "stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "bench_row.h"
#include "errors.h"

namespace wells {
namespace {

using Clock = std::chrono::steady_clock;

double sum(const StageTimes& times) {
  return std::accumulate(times.begin(), times.end(), 0.0);
}

}  // namespace

StageRow runStages(std::string_view scene, std::string_view method, Stepper& stepper, World world,
                   std::int64_t steps) {
  if (!stepper.openStageClock())
    throw RunError(fmt::format("engine {} has no clock of its stages", stepper.name()));
  StageRow row{std::string(scene), std::string(method), steps};
  const auto share = 1 / static_cast<double>(std::max<std::int64_t>(1, steps));
  for (std::int64_t step = 0; step < steps; ++step) {
    const auto before = Clock::now();
    stepper.step(world);
    row.stepTime += std::chrono::duration<double>(Clock::now() - before).count() * share;
    for (std::size_t i = 0; i < row.mean.size(); ++i)
      row.mean[i] += (*stepper.stageTimes())[i] * share;
  }
  return row;
}

std::string stageText(std::span<const StageRow> rows) {
  std::string text = fmt::format("{:<10} {:<18} {:>9} {:>9}", "ms a step", "", "step", "sum");
  for (const std::string_view stage : kStageNames) text += fmt::format(" {:>10}", stage);
  text += '\n';
  for (const StageRow& row : rows) {
    text += fmt::format("{:<10} {:<18} {:>9.4g} {:>9.4g}", row.scene, row.method,
                        1e3 * row.stepTime, 1e3 * sum(row.mean));
    for (const double time : row.mean) text += fmt::format(" {:>10.3g}", 1e3 * time);
    text += '\n';
  }
  return text;
}

std::string stageCsv(std::span<const StageRow> rows) {
  std::string csv = "scene,method,steps,step_ms,sum_ms";
  for (const std::string_view stage : kStageNames) csv += fmt::format(",{}_ms", stage);
  csv += fmt::format(",{}\n", kBuildColumns);
  for (const StageRow& row : rows) {
    csv += fmt::format("{},{},{},{:.6g},{:.6g}", row.scene, csvField(row.method), row.steps,
                       1e3 * row.stepTime, 1e3 * sum(row.mean));
    for (const double time : row.mean) csv += fmt::format(",{:.6g}", 1e3 * time);
    csv += fmt::format(",{}\n", buildColumns());
  }
  return csv;
}

}  // namespace wells
