// Ladders as JSON: how a process that holds one engine hands its points to the one that draws.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "work_precision.h"

namespace wells {

/// Without shares and books, which no engine has that runs in a process of its own.
std::string laddersAsJson(std::span<const Ladder> ladders);

/// Throws RunError for what laddersAsJson() did not write.
std::vector<Ladder> laddersFromJson(std::string_view text);

}  // namespace wells
