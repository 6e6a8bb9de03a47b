// The scenes that the program, the tests and the benchmarks share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "state/world.h"

namespace wells {

struct Scene {
  std::string_view name;   // what --scene takes
  std::string_view about;  // one line: what it shows
  std::size_t defaultBalls;
  std::size_t fixedBalls;  // not 0: the only number of balls that it has
  std::int64_t defaultSteps;
  bool sleeping;  // whether engines that can let balls at rest sleep do so in benchmarks
  World (*make)(std::size_t balls, std::uint64_t seed);  // dt = 1/60 s
};

std::span<const Scene> scenes();

/// The scene of that name, or throws std::invalid_argument with the names that exist.
const Scene& findScene(std::string_view name);

/// The world of a scene. balls = 0: the scene's default. Throws std::invalid_argument when the
/// scene has a fixed number of balls and another one is asked for.
World makeScene(const Scene& scene, std::size_t balls = 0, std::uint64_t seed = 1);

}  // namespace wells
