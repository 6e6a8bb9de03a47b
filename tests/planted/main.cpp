// gravity-wells-planted: which promise catches each planted defect, and how soon.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "planted/catching.h"
#include "planted/defects.h"

namespace wells::planted {
namespace {

struct Options {
  std::uint64_t seeds = 3000;
  std::uint64_t control = 3000;
  std::vector<std::string> only;
};

/// A seed that breaks a promise without any defect tells nothing about one.
bool failsAnyway(std::uint64_t seed) {
  static std::map<std::uint64_t, bool> known;
  const auto [entry, isNew] = known.try_emplace(seed);
  if (isNew) entry->second = simulateSeed(0, seed).has_value();
  return entry->second;
}

std::string row(const Defect& defect, const Options& options) {
  std::string bySimulation = "-", bySearch = "-", promise = "SURVIVED";
  for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) {
    const auto caught = simulateSeed(defect.number, seed);
    if (!caught || failsAnyway(seed)) continue;
    promise = caught->promise;
    bySimulation = fmt::format("{}", seed);
    break;
  }
  static const bool searchFailsAnyway = search(0).has_value();
  if (searchFailsAnyway) {
    bySearch = "?";
  } else if (const auto caught = search(defect.number)) {
    if (promise == "SURVIVED") promise = caught->promise;
    bySearch = fmt::format("{}", caught->count);
  }
  return fmt::format("{:24} | {:28} | {:20} | {:>6} | {:>8}\n", defect.name, defect.file, promise,
                     bySimulation, bySearch);
}

}  // namespace
}  // namespace wells::planted

int main(int argc, char** argv) {
  using namespace wells::planted;
  Options options;
  CLI::App app("Runs each planted defect until a promise is broken.");
  app.option_defaults()->always_capture_default();
  app.add_option("--seeds", options.seeds, "seeds to simulate, at most, for each");
  app.add_option("--control", options.control, "seeds to simulate without a defect");
  app.add_option("--only", options.only, "names of defects");
  CLI11_PARSE(app, argc, argv);
  for (const Defect& defect : defects()) {
    if (!options.only.empty() && !std::ranges::count(options.only, defect.name)) continue;
    fmt::print("{}", row(defect, options));
    std::fflush(stdout);
  }
}
