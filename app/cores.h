// Lists of processor cores as text, "0,2-5", and the config keys that take them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keys.h"

namespace wells {

/// The numbers of a list, rising, each once. Throws BadValue.
std::vector<int> parseCores(std::string_view text);

/// The shortest list of rising numbers.
std::string formatCores(std::span<const int> cores);

/// auto, any, or a list.
Key coresKey(std::string name, CoreChoice Config::*choice, std::string help);

}  // namespace wells
