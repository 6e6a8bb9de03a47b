// Which faults have hit peers in which states: the table that tells what a run of many seeds has
// not tried.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/tally.h"

namespace wells::simulation {

/// Why a fault cannot hit a peer in this state; empty: it can.
std::string_view whyNever(FaultKind kind, PeerState state);

/// "crash x syncing" for each cell that could be hit and was not.
std::vector<std::string> emptyCells(const Coverage& coverage);

/// The table in lines of at most 110 characters, with the reasons for what cannot be below it.
std::string coverageTable(const Tally& tally);

}  // namespace wells::simulation
