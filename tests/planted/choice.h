// Which of the planted defects the copies of the engine have now. Not for the engine itself.
#pragma once

namespace wells::planted {

/// The number of the defect in defects.txt; 0: none. Set it while nothing runs.
inline int choice = 0;

inline bool has(int defect) {
  return choice == defect;
}

}  // namespace wells::planted
