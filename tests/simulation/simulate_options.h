// The command line of gravity-wells-simulate.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "simulation/draw_schedule.h"

namespace wells::simulation {

struct SimulateOptions {
  std::optional<std::int64_t> seed;  // one run, with its event log
  std::int64_t seeds = 1000;         // otherwise so many ...
  std::int64_t first = 1;            // ... from here on
  std::int64_t jobs = 1;
  std::filesystem::path coverage;  // empty: none is written
  SessionShape shape;
};

/// Nothing when the help was asked for, and shown. Throws UsageError.
std::optional<SimulateOptions> parseSimulateOptions(std::span<const std::string> arguments);

}  // namespace wells::simulation
