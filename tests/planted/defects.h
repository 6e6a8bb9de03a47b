// The defects of defects.txt that are planted in the copies of the engine.
#pragma once

#include <span>
#include <string_view>

namespace wells::planted {

struct Defect {
  int number = 0;  // chooses it, see choice.h
  std::string_view name;
  std::string_view what;
  std::string_view file;    // relative to engine/
  std::string_view faults;  // names of those that it takes, with ", " between; empty: any
};

/// In the order of the table.
std::span<const Defect> defects();

}  // namespace wells::planted
