// Balls in CSV files: what BallsFile reads and --state-out writes. 17 significant digits carry a
// double exactly, so a state that is written and read again has the same bits.
#pragma once

#include <filesystem>
#include <string>

#include "state/balls.h"

namespace wells {

inline constexpr std::string_view kBallsHeader = "id,x,y,z,vx,vy,vz,wx,wy,wz,radius,mass";

/// Rows may stand in any order; ids are 0 .. N-1, each once. Throws UsageError with file, line,
/// column, value and what is allowed.
Balls readBalls(const std::filesystem::path& file);

/// The file's text, in order of id.
std::string ballsAsCsv(const Balls& balls);

}  // namespace wells
