// Tells people how two worlds differ.
#pragma once

#include <string>
#include <string_view>

namespace wells {

/// The first key of two canonical configs (KEY=VALUE lines) whose values differ, in a sentence:
/// "BallRadius is 0.6 there and 0.5 here". Texts that are equal differ in what they refer to.
std::string describeDifference(std::string_view theirs, std::string_view ours);

}  // namespace wells
