// How far a peer has come in a session.
#pragma once

#include <cstdint>
#include <string_view>

namespace wells {

enum class Phase : std::uint8_t {
  Joining,  // listening
  Syncing,  // knows the generation, gathers states
  Active,   // simulates, owns, may be offered balls
  Leaving,  // said good-bye
};

/// For reports: "joining", ...
constexpr std::string_view name(Phase phase) {
  switch (phase) {
    case Phase::Joining:
      return "joining";
    case Phase::Syncing:
      return "syncing";
    case Phase::Active:
      return "active";
    case Phase::Leaving:
      return "leaving";
  }
  return "unknown";
}

}  // namespace wells
