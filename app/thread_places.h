// Which cores a peer's threads run on, and how many threads its simulation gets. The original kept
// graphics on the first core, the network on the second and the simulation on all others, so that
// none of the three loops waits for another.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config.h"

namespace wells {

/// What runs beside the simulation.
struct OtherLoops {
  bool graphics = false;
  bool network = false;
};

struct ThreadPlaces {
  int simulationThreads = 1;
  std::vector<int> simulation{};               // cores; empty: any
  std::optional<std::vector<int>> graphics{};  // likewise; nothing: there is no such loop
  std::optional<std::vector<int>> network{};
  std::string why{};  // for people: what they are pinned by, or why not

  /// "any", "none", or the list.
  static std::string text(const std::optional<std::vector<int>>& cores);
};

/// `allowed`: the cores that this process may use, rising, at least one, of a machine with
/// `coresOfMachine`. Throws UsageError where a key names others.
ThreadPlaces placeThreads(const Config& config, const OtherLoops& loops,
                          std::span<const int> allowed, int coresOfMachine);

/// The same on this machine.
ThreadPlaces placeThreads(const Config& config, const OtherLoops& loops);

/// Names this thread and, unless `cores` is empty, keeps it and those that it starts on them.
/// Throws RunError when the system does not let it.
void placeThisThread(const std::string& name, std::span<const int> cores);

}  // namespace wells
