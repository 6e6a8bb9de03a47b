#include "contacts/touching_islands.h"

#include <numeric>

#include "math/union_find.h"

namespace wells {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

void TouchingIslands::find(std::span<Contact> balls, std::span<Contact> arena,
                           std::size_t ballCount) {
  const auto forEach = [&](auto action) {
    for (const auto& list : {balls, arena})
      for (Contact& c : list)
        if (c.acts) action(c);
  };
  parent_.resize(ballCount);
  islandOf_.resize(ballCount);
  forEach([&](const Contact& c) {
    for (const std::uint32_t i : {c.a, c.b}) {
      if (!isBall(i)) continue;
      parent_[i] = i;
      islandOf_[i] = kNone;
    }
  });
  forEach([&](const Contact& c) {
    if (isBall(c.b)) parent_[rootOf(parent_, c.a)] = rootOf(parent_, c.b);
  });

  // Number the islands and count, then fill.
  start_.assign(1, 0);
  forEach([&](const Contact& c) {
    std::uint32_t& island = islandOf_[rootOf(parent_, c.a)];
    if (island == kNone) {
      island = static_cast<std::uint32_t>(start_.size() - 1);
      start_.push_back(0);
    }
    ++start_[island + 1];
  });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  next_.assign(start_.begin(), start_.end() - 1);
  contacts_.resize(start_.back());
  forEach([&](Contact& c) { contacts_[next_[islandOf_[rootOf(parent_, c.a)]]++] = &c; });
}

}  // namespace wells
