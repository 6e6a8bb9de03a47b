// What ends the program on purpose, with the exit status that it then has.
#pragma once

#include <stdexcept>
#include <string>

namespace wells {

inline constexpr int kExitFailure = 1;  // the machine or a peer failed
inline constexpr int kExitUsage = 2;    // the user asked for something that is not allowed

/// A wrong key, value, option or input file. what() names the place, the thing, its value and what
/// is allowed. Thrown before anything is started.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something outside the program is missing or failed: a route, ffmpeg, a full disk.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wells
