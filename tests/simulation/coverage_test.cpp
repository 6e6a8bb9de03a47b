// The table of what the faults have hit: that it shows what is missing, and that the kept one, of
// many seeds, has no empty cell.
#include "simulation/coverage.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace wells::simulation {
namespace {

Coverage full() {
  Coverage coverage{};
  for (auto& row : coverage) row.fill(1);
  return coverage;
}

TEST(Coverage, NamesTheCellsThatAreEmpty) {
  Coverage coverage = full();
  EXPECT_EQ(emptyCells(coverage), std::vector<std::string>{});
  coverage[static_cast<std::size_t>(FaultKind::Stall)]
          [static_cast<std::size_t>(PeerState::Syncing)] = 0;
  EXPECT_EQ(emptyCells(coverage), std::vector<std::string>{"stall x syncing"});
}

TEST(Coverage, WhatCannotBeIsNoEmptyCell) {
  Coverage coverage = full();
  coverage[static_cast<std::size_t>(FaultKind::Leave)]
          [static_cast<std::size_t>(PeerState::Leaving)] = 0;
  EXPECT_EQ(emptyCells(coverage), std::vector<std::string>{});
  EXPECT_NE(whyNever(FaultKind::Leave, PeerState::Leaving), "");
}

TEST(Coverage, TheKeptTableHasNoEmptyCell) {
  std::ifstream file(COVERAGE_FILE);
  ASSERT_TRUE(file) << COVERAGE_FILE;
  std::size_t rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (rows == kFaultKinds || !line.starts_with(kFaultNames[rows])) continue;
    std::istringstream cells(line.substr(kFaultNames[rows].size()));
    for (std::size_t state = 0; state < kPeerStates; ++state) {
      std::string cell;
      ASSERT_TRUE(cells >> cell) << line;
      const bool isNever =
          !whyNever(static_cast<FaultKind>(rows), static_cast<PeerState>(state)).empty();
      EXPECT_EQ(cell == "-", isNever) << line;
      EXPECT_NE(cell, "0") << kFaultNames[rows] << " x " << kPeerStateNames[state];
    }
    ++rows;
  }
  EXPECT_EQ(rows, kFaultKinds);
}

}  // namespace
}  // namespace wells::simulation
