#include "speed_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace wells {
namespace {

constexpr std::string_view kAll = "ms_per_step";
constexpr std::string_view kLast = "ms_per_step_last100";

// Bullet's balls fall asleep after 2 s, 120 steps: of T3 the last 100 steps count. Heaps of 50,000
// balls and more take Bullet most of a second a step: within the first second of their time all
// balls have come down.
constexpr SpeedScene kScenes[] = {
    {"T1-25", "T1", 25, 300, 21, kAll, 15},       {"T1-1000", "T1", 1000, 300, 3, kAll, 40},
    {"T3-10000", "T3", 10000, 300, 1, kLast, 25}, {"T2-10000", "T2", 10000, 300, 1, kAll, 60},
    {"T1-10000", "T1", 10000, 300, 1, kAll, 260}, {"T1-50000", "T1", 50000, 60, 1, kAll, 110},
    {"T1-100000", "T1", 100000, 60, 1, kAll, 110}};

/// Exact impacts of heaps this large take for ever.
constexpr std::int64_t kMostExact = 10000;

}  // namespace

std::string name(const SpeedMethod& method) {
  if (method.isBullet()) return "stock Bullet";
  std::string text = "ours";
  if (!method.contacts.empty()) text += " " + method.contacts;
  if (method.substeps > 0) text += fmt::format(" {}x{}", method.substeps, method.iterations);
  if (method.threads > 1) text += fmt::format(" on {} threads", method.threads);
  return text;
}

std::vector<std::string> arguments(const SpeedMethod& method) {
  std::vector<std::string> words = {"--engine", method.engine};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  if (!method.contacts.empty()) add("--contacts", method.contacts);
  if (method.substeps > 0) add("--substeps", std::to_string(method.substeps));
  if (method.iterations > 0) add("--iterations", std::to_string(method.iterations));
  if (method.threads > 1) add("--threads", std::to_string(method.threads));
  return words;
}

void apply(const SpeedMethod& method, Settings& settings) {
  if (const auto contacts = contactMethod(method.contacts)) settings.contactMethod = *contacts;
  if (method.substeps > 0) settings.substeps = static_cast<int>(method.substeps);
  if (method.iterations > 0) settings.iterations = static_cast<int>(method.iterations);
}

std::span<const SpeedScene> speedScenes() {
  return kScenes;
}

const SpeedScene& findSpeedScene(std::string_view name) {
  return *std::ranges::find(kScenes, name, &SpeedScene::name);
}

std::vector<SpeedMethod> speedMethods(const SpeedScene& scene,
                                      std::span<const std::int64_t> threads) {
  std::vector<SpeedMethod> methods(2);
  methods[0].engine = "bullet";
  for (const std::int64_t count : threads) {
    SpeedMethod method;
    method.threads = count;
    if (count > 1) methods.push_back(method);
  }
  for (const char* contacts : {"substep", "exact"}) {
    SpeedMethod method;
    method.contacts = contacts;
    if (!method.mayNotEnd() || scene.balls <= kMostExact) methods.push_back(method);
  }
  return methods;
}

bool isHeap(const SpeedScene& scene) {
  return scene.scene == "T1" && scene.balls >= 10000;
}

}  // namespace wells
