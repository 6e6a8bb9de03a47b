#include "contacts/touching_islands.h"

#include <numeric>

#include "math/union_find.h"

namespace wells {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

void TouchingIslands::find(std::span<Contact> balls, std::span<Contact> arena,
                           std::size_t ballCount) {
  acting_.clear();
  for (const auto& list : {balls, arena})
    for (Contact& c : list)
      if (c.acts) acting_.push_back(&c);
  parent_.resize(ballCount);
  islandOf_.resize(ballCount);
  for (const Contact* c : acting_)
    for (const std::uint32_t i : {c->a, c->b}) {
      if (!isBall(i)) continue;
      parent_[i] = i;
      islandOf_[i] = kNone;
    }
  for (const Contact* c : acting_)
    if (isBall(c->b)) parent_[rootOf(parent_, c->a)] = rootOf(parent_, c->b);

  // Number the islands and count, then fill.
  start_.assign(1, 0);
  for (const Contact* c : acting_) {
    std::uint32_t& island = islandOf_[rootOf(parent_, c->a)];
    if (island == kNone) {
      island = static_cast<std::uint32_t>(start_.size() - 1);
      start_.push_back(0);
    }
    ++start_[island + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  next_.assign(start_.begin(), start_.end() - 1);
  contacts_.resize(start_.back());
  for (Contact* c : acting_) contacts_[next_[islandOf_[rootOf(parent_, c->a)]]++] = c;
}

}  // namespace wells
