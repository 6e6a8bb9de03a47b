// States and events of the search in words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "search/model.h"

namespace wells {

/// One event. `ball` for those of a ball; `record` is what the one who does it had of it.
std::string describe(const Event& event, const Group& before, const Group& after,
                     std::optional<int> ball, Word record, const Model& model);

/// Who is what, and knows what of each ball: a line for each peer.
std::vector<std::string> describe(const Group& group, std::span<const Knowledge> balls,
                                  const Model& model, const Limits& limits);

}  // namespace wells
