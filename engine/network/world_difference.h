// Tells people how two worlds differ.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace wells {

/// The value of a key that is not set, as text; empty: there is none, or no such key.
using DefaultValue = std::function<std::string(std::string_view key)>;

/// The first key of two canonical configs (KEY=VALUE lines) whose values differ, in a sentence:
/// "BallRadius is 0.6 there and 0.5 (the default) here". Texts that are equal differ in what they
/// refer to.
std::string describeDifference(std::string_view theirs, std::string_view ours,
                               const DefaultValue& defaultOf = {});

}  // namespace wells
