// What must come out of a scene: the answers that accuracy is measured against. Mostly where its
// balls must be at a given time: closed forms, or digits of an independent computation; the tests
// derive each of them again. Where many balls meet nobody knows that, and what physics keeps is the
// answer.
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

/// What is wrong in a run. Energy and Penetration as SimBenchmark has them, over the states with
/// which the steps begin.
enum class ErrorKind : std::uint8_t {
  Position,     // m, the largest distance of a ball at the end from where it must be
  Energy,       // root of the mean of (E - E0)^2, relative to E0, the energy of the start
  Penetration,  // m^2, mean of the sum of the squares of all overlaps
  Deformation,  // m, the largest change of a height or of a distance between two balls at the end
  EndEnergy,    // of the kinetic energy at the end, relative to what it must be
};

/// "m", "1" for a ratio, "m^2"
std::string_view unitOf(ErrorKind kind);

/// "largest error of a position at the end", ...
std::string_view describe(ErrorKind kind);

/// One case of the accuracy suite and of the work-precision benchmark.
struct AccuracyCase {
  std::string_view scene;          // name in the catalogue
  std::string_view about;          // one line: what is hard about it
  double duration;                 // s, from the scene's start
  std::vector<ExactPosition> end;  // empty where the error is of another kind
  ErrorKind error = ErrorKind::Position;
  double endEnergy = 0;  // J, where that is what is known
};

std::span<const AccuracyCase> accuracyCases();

/// The case of that scene, or throws std::invalid_argument with the names that exist.
const AccuracyCase& findAccuracyCase(std::string_view scene);

/// The largest distance (m) of a ball of `world` from where `answer` has it; infinite if a state is
/// not finite. Of cases with that kind of error.
double positionError(const AccuracyCase& answer, const World& world);

}  // namespace wells
