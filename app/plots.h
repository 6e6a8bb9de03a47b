// The pictures of the work-precision benchmark: gnuplot scripts beside the tables that they read,
// so that anyone can draw them again, and gnuplot run on them.
#pragma once

#include <filesystem>
#include <span>

#include "accuracy_files.h"

namespace wells {

/// Writes <case>.gp for each case and overview.gp into `folder`, where <case>.csv are. Drawn with
/// `gnuplot FILE.gp` in that folder, each makes the PNG of its name. Throws RunError.
void writePlotScripts(const std::filesystem::path& folder, std::span<const CaseResult> cases);

/// Runs gnuplot on these scripts. Throws RunError when it is missing or fails.
void drawPlots(const std::filesystem::path& folder, std::span<const CaseResult> cases);

}  // namespace wells
