#include "simulation/coverage.h"

#include <fmt/format.h>

namespace wells::simulation {

std::string_view whyNever(FaultKind kind, PeerState state) {
  const bool isOutside = state == PeerState::Joining || state == PeerState::Syncing;
  const bool isOver = state == PeerState::Leaving;
  switch (kind) {
    case FaultKind::CrashBeforeOffer:
    case FaultKind::CrashAfterOffer:
    case FaultKind::CrashAfterAnswer:
      if (isOutside) return "who is not active makes no offers";
      if (isOver) return "who has said good-bye makes no offers";
      break;
    case FaultKind::Leave:
      if (isOver) return "it has left";
      break;
    default:
      break;
  }
  return {};
}

std::vector<std::string> emptyCells(const Coverage& coverage) {
  std::vector<std::string> empty;
  for (std::size_t i = 0; i < kFaultKinds; ++i) {
    for (std::size_t j = 0; j < kPeerStates; ++j) {
      const auto kind = static_cast<FaultKind>(i);
      const auto state = static_cast<PeerState>(j);
      if (coverage[i][j] == 0 && whyNever(kind, state).empty())
        empty.push_back(fmt::format("{} x {}", name(kind), name(state)));
    }
  }
  return empty;
}

std::string coverageTable(const Tally& tally) {
  std::string table = fmt::format(
      "How often each fault hit a peer in each state, in {} runs, {:.1f} simulated hours.\n"
      "An active peer can be in several states at once. What befalls all counts for each peer.\n\n",
      tally.runs, tally.seconds / 3600);
  fmt::format_to(std::back_inserter(table), "{:<19}", "");
  for (const std::string_view state : kPeerStateNames)
    fmt::format_to(std::back_inserter(table), "{:>13}", state);
  table += '\n';
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < kFaultKinds; ++i) {
    fmt::format_to(std::back_inserter(table), "{:<19}", kFaultNames[i]);
    for (std::size_t j = 0; j < kPeerStates; ++j) {
      const auto why = whyNever(static_cast<FaultKind>(i), static_cast<PeerState>(j));
      if (why.empty()) {
        fmt::format_to(std::back_inserter(table), "{:>13}", tally.coverage[i][j]);
        continue;
      }
      table += fmt::format("{:>13}", "-");
      reasons.push_back(fmt::format("{} x {}: {}", kFaultNames[i], kPeerStateNames[j], why));
    }
    table += '\n';
  }
  table += "\n- cannot be:\n";
  for (const std::string& reason : reasons) table += "  " + reason + '\n';
  return table;
}

}  // namespace wells::simulation
