#include "thread_places.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "cores.h"
#include "errors.h"
#include "threads/placement.h"

namespace wells {
namespace {

// The others are kept apart only where this many are left for the simulation.
constexpr std::size_t kLeastForSimulation = 2;

constexpr std::size_t kMostUnasked = 8;  // threads: beyond, memory is what a step waits for

using Kind = CoreChoice::Kind;

std::vector<int> listed(std::string_view key, const CoreChoice& choice,
                        std::span<const int> allowed, int coresOfMachine) {
  for (const int core : choice.listed) {
    if (std::find(allowed.begin(), allowed.end(), core) != allowed.end()) continue;
    throw UsageError(
        fmt::format("{}={}: {}; allowed: {}", key, formatCores(choice.listed),
                    core >= coresOfMachine
                        ? fmt::format("this machine has no core {}", core)
                        : fmt::format("this process may not run on core {} (see taskset)", core),
                    formatCores(allowed)));
  }
  return choice.listed;
}

void keepApart(std::span<const int> allowed, ThreadPlaces& places) {
  const std::size_t others = (places.graphics ? 1u : 0u) + (places.network ? 1u : 0u);
  if (others == 0) {
    places.why = "not pinned: no loop runs beside the simulation";
    return;
  }
  if (allowed.size() < others + kLeastForSimulation) {
    places.why = fmt::format("not pinned: to keep the loops apart takes {} cores, and there are {}",
                             others + kLeastForSimulation, allowed.size());
    return;
  }
  for (auto* const loop : {&places.graphics, &places.network}) {
    if (!*loop) continue;
    (*loop)->push_back(allowed.front());
    allowed = allowed.subspan(1);
  }
  places.simulation.assign(allowed.begin(), allowed.end());
  places.why = "pinned: each loop has cores of its own";
}

int threadsFor(const Config& config, const ThreadPlaces& places, std::size_t allowed) {
  if (config.threads > 0) return static_cast<int>(config.threads);
  std::size_t cores = places.simulation.size();
  if (cores == 0) cores = allowed - (places.graphics && allowed > 1 ? 1 : 0);
  return static_cast<int>(std::min(cores, kMostUnasked));
}

}  // namespace

std::string ThreadPlaces::text(const std::optional<std::vector<int>>& cores) {
  if (!cores) return "none";
  return cores->empty() ? "any" : formatCores(*cores);
}

ThreadPlaces placeThreads(const Config& config, const OtherLoops& loops,
                          std::span<const int> allowed, int coresOfMachine) {
  ThreadPlaces places;
  const auto take = [&](std::string_view key, const CoreChoice& choice) {
    return listed(key, choice, allowed, coresOfMachine);
  };
  places.simulation = take("SimulationCores", config.simulationCores);
  const auto graphics = take("GraphicsCores", config.graphicsCores);
  const auto network = take("NetworkCores", config.networkCores);
  if (loops.graphics) places.graphics = graphics;
  if (loops.network) places.network = network;

  const auto isAuto = [](const CoreChoice& choice) { return choice.kind == Kind::Auto; };
  if (isAuto(config.simulationCores) && isAuto(config.graphicsCores) && isAuto(config.networkCores))
    keepApart(allowed, places);
  else
    places.why = "as the keys say";
  places.simulationThreads = threadsFor(config, places, allowed.size());
  return places;
}

ThreadPlaces placeThreads(const Config& config, const OtherLoops& loops) {
  return placeThreads(config, loops, allowedCores(),
                      static_cast<int>(::sysconf(_SC_NPROCESSORS_CONF)));
}

void placeThisThread(const std::string& name, std::span<const int> cores) {
  nameThisThread(name);
  if (!cores.empty() && !pinThisThread(cores))
    throw RunError(
        fmt::format("the thread of {} cannot be kept on core {}", name, formatCores(cores)));
}

}  // namespace wells
