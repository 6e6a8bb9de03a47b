// Where the balls of a scene must be at a given time: the answers that accuracy is measured
// against. Closed forms, or digits of an independent computation; the tests derive each of them
// again.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "state/world.h"

namespace wells {

struct ExactPosition {
  std::uint32_t ball = 0;
  Vec3 position = Vec3::Zero();  // m
};

/// One case of the accuracy suite and of the work-precision benchmark.
struct AccuracyCase {
  std::string_view scene;  // name in the catalogue
  std::string_view about;  // one line: what is hard about it
  double duration;         // s, from the scene's start
  std::vector<ExactPosition> end;
};

std::span<const AccuracyCase> accuracyCases();

/// The case of that scene, or throws std::invalid_argument with the names that exist.
const AccuracyCase& findAccuracyCase(std::string_view scene);

/// The largest distance (m) of a ball of `world` from where `answer` has it; infinite if a state is
/// not finite.
double positionError(const AccuracyCase& answer, const World& world);

}  // namespace wells
