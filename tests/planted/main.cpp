// gravity-wells-planted: which promise catches each planted defect, and how soon: caught.txt.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "planted/catching.h"
#include "planted/defects.h"

namespace wells::planted {
namespace {

struct Options {
  std::uint64_t seeds = 1000;
  std::uint64_t control = 1000;
  std::vector<std::string> only;
};

void print(std::string_view defect, std::string_view file, std::string_view caughtBy,
           std::string_view seeds, std::string_view states) {
  fmt::print("{:24} | {:28} | {:6} | {:6} | {}\n", defect, file, seeds, states, caughtBy);
  std::fflush(stdout);
}

void printControl(const Options& options) {
  std::uint64_t violations = 0;
  for (std::uint64_t seed = 1; seed <= options.control; ++seed)
    if (simulate({}, seed, Planting::On)) ++violations;
  const Searched searched = search({});
  if (searched.caught) ++violations;
  print("none", "",
        fmt::format("{} violations in {} seeds and {} states", violations, options.control,
                    searched.states),
        "-", "-");
}

/// True when it was caught.
bool printRow(const Defect& defect, const Options& options) {
  std::string caughtBy, seeds = "-", states = "-";
  for (std::uint64_t seed = 1; seed <= options.seeds && caughtBy.empty(); ++seed) {
    const auto caught = simulate(defect, seed, Planting::On);
    // What breaks a promise without the defect, too, tells nothing about it.
    if (!caught || simulate(defect, seed, Planting::Off)) continue;
    caughtBy = caught->promise;
    seeds = fmt::format("{}", seed);
  }
  if (defect.file.starts_with("ownership/")) {
    if (const Searched searched = search(defect); searched.caught) {
      caughtBy += fmt::format("{}{}", caughtBy.empty() ? "" : "; ", searched.caught->promise);
      states = fmt::format("{}", searched.states);
    }
  }
  print(defect.name, defect.file, caughtBy.empty() ? "SURVIVED" : caughtBy, seeds, states);
  return !caughtBy.empty();
}

bool run(const Options& options) {
  print("defect", "file", "broken promise: of the simulator; of the search", "seeds", "states");
  if (options.only.empty()) printControl(options);
  bool allCaught = true;
  for (const Defect& defect : defects())
    if (options.only.empty() || std::ranges::count(options.only, defect.name) > 0)
      allCaught = printRow(defect, options) && allCaught;
  return allCaught;
}

}  // namespace
}  // namespace wells::planted

int main(int argc, char** argv) {
  using namespace wells::planted;
  Options options;
  CLI::App app(
      "Runs each planted defect until a promise is broken, and prints the table of what caught it. "
      "Exit status 1: one survived.");
  app.option_defaults()->always_capture_default();
  app.add_option("--seeds", options.seeds, "seeds to simulate, at most, for each");
  app.add_option("--control", options.control, "seeds to simulate without a defect");
  app.add_option("--only", options.only, "names of defects");
  CLI11_PARSE(app, argc, argv);
  return run(options) ? 0 : 1;
}
