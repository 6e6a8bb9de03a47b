// Looks a name up in a table of values.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace wells {

/// The item whose `member` is `name`, or throws std::invalid_argument with the names that exist;
/// `kind` says what they name.
template <class Items, class Member>
const auto& findByName(const Items& items, Member member, std::string_view kind,
                       std::string_view name) {
  for (const auto& item : items)
    if (std::invoke(member, item) == name) return item;
  std::vector<std::string_view> names;  // only now: each step looks its integrator up
  for (const auto& item : items) names.push_back(std::invoke(member, item));
  throw std::invalid_argument(
      fmt::format("{} '{}' is unknown; allowed: {}", kind, name, fmt::join(names, ", ")));
}

}  // namespace wells
