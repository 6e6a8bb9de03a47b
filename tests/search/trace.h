// States and events of the search in words.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "search/model.h"

namespace wells {

/// One event; `ball` for those of a ball.
std::string describe(const Event& event, const Group& before, const Group& after,
                     std::optional<int> ball, const Model& model);

/// Who is what, and knows what of each ball; one line a peer.
std::string describe(const Group& group, std::span<const Knowledge> balls, const Model& model,
                     const Limits& limits);

}  // namespace wells
