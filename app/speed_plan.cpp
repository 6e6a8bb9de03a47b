#include "speed_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace wells {
namespace {

constexpr std::string_view kAll = "ms_per_step";
constexpr std::string_view kLast = "ms_per_step_last100";

// Few substeps and passes that keep the bound. Of T1-10000 the bounds are what Box3D and ODE leave
// there. An integrator of order 4 is wasted on heaps whose contacts are of order 1.
constexpr std::string_view kLeapfrog = "leapfrog";
constexpr SpeedMethod kTuned25[] = {
    {.contacts = "substep", .substeps = 1, .iterations = 4, .integrator = kLeapfrog}};
constexpr SpeedMethod kTuned1000[] = {{.substeps = 2, .iterations = 2, .integrator = kLeapfrog}};
constexpr SpeedMethod kTuned10000[] = {
    {.substeps = 3, .iterations = 3, .integrator = kLeapfrog, .ballBound = 0.086},
    {.substeps = 4, .iterations = 3, .integrator = kLeapfrog, .ballBound = 0.049}};
constexpr SpeedMethod kTuned50000[] = {{.substeps = 2, .iterations = 6, .integrator = kLeapfrog}};
constexpr SpeedMethod kTuned100000[] = {{.substeps = 2, .iterations = 6, .integrator = kLeapfrog}};

// Bullet's balls fall asleep after 2 s, 120 steps: of T3 the last 100 steps count. Heaps of 50,000
// balls and more take Bullet most of a second a step: within the first second of their time all
// balls have come down.
constexpr SpeedScene kScenes[] = {{"T1-25", "T1", 25, 300, 21, kAll, 2, kTuned25},
                                  {"T1-1000", "T1", 1000, 300, 3, kAll, 8, kTuned1000},
                                  {"T3-10000", "T3", 10000, 300, 1, kLast, 5, {}},
                                  {"T2-10000", "T2", 10000, 300, 1, kAll, 12, {}},
                                  {"T1-10000", "T1", 10000, 300, 1, kAll, 50, kTuned10000},
                                  {"T1-50000", "T1", 50000, 60, 1, kAll, 50, kTuned50000},
                                  {"T1-100000", "T1", 100000, 60, 1, kAll, 115, kTuned100000}};

/// With more balls, only the default and the tuned settings: rounds are long.
constexpr std::int64_t kMostForEachMethod = 10000;

/// With fewer, tuned settings on one thread only: worlds this small stay on one.
constexpr std::int64_t kFewestForThreads = 10000;

}  // namespace

std::string name(const SpeedMethod& method) {
  if (method.isBullet()) return "stock Bullet";
  std::string text = "ours";
  if (!method.contacts.empty()) text += fmt::format(" {}", method.contacts);
  if (method.substeps > 0) text += fmt::format(" {}x{}", method.substeps, method.iterations);
  if (!method.integrator.empty()) text += fmt::format(" {}", method.integrator);
  if (method.threads > 1) text += fmt::format(" on {} threads", method.threads);
  return text;
}

std::vector<std::string> arguments(const SpeedMethod& method) {
  std::vector<std::string> words = {"--engine", std::string(method.engine)};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  if (!method.contacts.empty()) add("--contacts", std::string(method.contacts));
  if (method.substeps > 0) add("--substeps", std::to_string(method.substeps));
  if (method.iterations > 0) add("--iterations", std::to_string(method.iterations));
  if (!method.integrator.empty()) add("--integrator", std::string(method.integrator));
  if (method.threads > 1) add("--threads", std::to_string(method.threads));
  return words;
}

void apply(const SpeedMethod& method, Settings& settings) {
  if (const auto contacts = contactMethod(method.contacts)) settings.contactMethod = *contacts;
  if (method.substeps > 0) settings.substeps = static_cast<int>(method.substeps);
  if (method.iterations > 0) settings.iterations = static_cast<int>(method.iterations);
  if (!method.integrator.empty()) settings.integrator = method.integrator;
}

std::span<const SpeedScene> speedScenes() {
  return kScenes;
}

const SpeedScene& findSpeedScene(std::string_view name) {
  return *std::ranges::find(kScenes, name, &SpeedScene::name);
}

std::vector<SpeedMethod> speedMethods(const SpeedScene& scene,
                                      std::span<const std::int64_t> threads) {
  std::vector<SpeedMethod> methods = {{.engine = "bullet"}};
  const auto addOnThreads = [&](SpeedMethod method) {
    methods.push_back(method);
    for (const std::int64_t count : threads)
      if ((method.threads = count) > 1) methods.push_back(method);
  };
  addOnThreads({});
  if (scene.balls <= kMostForEachMethod)
    methods.insert(methods.end(), {{.contacts = "substep"}, {.contacts = "exact"}});
  for (const SpeedMethod& method : scene.tuned) {
    if (scene.balls >= kFewestForThreads)
      addOnThreads(method);
    else
      methods.push_back(method);
  }
  return methods;
}

}  // namespace wells
