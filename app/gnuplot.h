// Runs gnuplot, the program.
#pragma once

#include <filesystem>
#include <string>

namespace wells {

/// Runs the script `file` of `folder` in that folder. Throws RunError when gnuplot is missing,
/// fails or hangs.
void runGnuplot(const std::filesystem::path& folder, const std::string& file);

}  // namespace wells
