#include "engines.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "errors.h"
#include "values.h"

namespace wells {

std::span<const std::string> engineNames() {
  static const std::vector<std::string> names = {
      "ours",         "reference-euler", "reference-improved-euler",
      "reference-rk", "reference-heun",  "reference-rk4",
      "bullet"};
  return names;
}

void requireEngine(std::string_view name) {
  const auto names = engineNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string nearest = nearestWord(name, names);
  throw UsageError(fmt::format("--engine {}: no such engine;{} allowed: {}", name,
                               nearest.empty() ? "" : " did you mean " + nearest + "?",
                               joined(names, ", ")));
}

void becomeExecutableOf(std::string_view engine, char** argv) {
  if (hasEngine(engine)) return;
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  const auto other =
      self.parent_path() / (engine == "bullet" ? "gravity-wells-bullet" : "gravity-wells");
  ::execv(other.c_str(), argv);
  throw RunError(fmt::format("--engine {}: {}: cannot be started: {}", engine, other.string(),
                             std::strerror(errno)));
}

}  // namespace wells
