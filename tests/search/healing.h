// What becomes of a group when faults end: all who run hear each other, nothing that was sent
// before comes any more, and each does what its session does. In the end everybody must be active
// in one generation, with equal records, and one peer must act as owner of the ball.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "search/group.h"
#include "search/knowledge.h"
#include "search/limits.h"
#include "search/transitions.h"

namespace wells {

/// In which order those who may adopt or found at the same time do so.
enum class Turns : std::uint8_t { LowestFirst, HighestFirst, AllAtOnce };

/// What is wrong in the end; nothing when the group is sound again. The group's limits do not hold
/// here. Several balls need no look at all of them together: a joiner that waits for one of them
/// hears of it from those who are active, who do not wait for the joiner.
std::optional<std::string> failureToHeal(const Group& group,
                                         const std::array<Entry, kMaxPeers>& entries,
                                         const Limits& limits, const Protocol& protocol,
                                         Turns turns);

}  // namespace wells
