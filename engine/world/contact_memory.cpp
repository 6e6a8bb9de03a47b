#include "world/contact_memory.h"

#include <algorithm>
#include <cmath>

namespace wells {
namespace {

/// Not so beside a ball whose state stopped being finite.
bool isFiniteImpulse(const StepperMemory::Contact& c) {
  return std::isfinite(c.normalImpulse) && isFinite(c.tangentImpulse) && isFinite(c.rollingImpulse);
}

}  // namespace

const ContactMemory::Kept* ContactMemory::find(std::uint32_t a, std::uint32_t b) const {
  if (a + 1 >= firstOf_.size()) return nullptr;
  for (std::uint32_t n = firstOf_[a]; n < firstOf_[a + 1]; ++n)
    if (kept_[n].b == b) return isFiniteImpulse(kept_[n]) ? &kept_[n] : nullptr;
  return nullptr;
}

void ContactMemory::start(Contact& contact, double substep) const {
  const Kept* const kept = find(contact.a, contact.b);
  if (!kept) return;
  const double scale = scaleTo(substep);
  contact.normalImpulse = scale * kept->normalImpulse;
  contact.tangentImpulse = scale * kept->tangentImpulse;
  contact.rollingImpulse = scale * kept->rollingImpulse;
}

void ContactMemory::forget(double substep) {
  kept_.clear();
  substep_ = substep;
}

void ContactMemory::add(const Contact& c) {
  if (c.impact || !(c.normalImpulse > 0)) return;
  kept_.push_back({c.a, c.b, c.normalImpulse, c.tangentImpulse, c.rollingImpulse});
}

// By counting how many each ball has, then those few of a ball by comparing.
void ContactMemory::arrange() {
  index();
  const auto isOrdered = [](const Kept& x, const Kept& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  };
  if (std::ranges::is_sorted(kept_, isOrdered)) return;
  unsorted_.swap(kept_);
  kept_.resize(unsorted_.size());
  for (const Kept& c : unsorted_) kept_[firstOf_[c.a]++] = c;
  const auto isBefore = [](const Kept& x, const Kept& y) { return x.b < y.b; };
  std::uint32_t first = 0;
  for (std::uint32_t& last : firstOf_) {
    std::sort(kept_.begin() + first, kept_.begin() + last, isBefore);
    std::swap(first, last);
  }
}

/// Where the contacts of each ball begin, and behind all of them.
void ContactMemory::index() {
  std::uint32_t most = 0;
  for (const Kept& c : kept_) most = std::max(most, c.a + 2);
  firstOf_.assign(most, 0);
  for (const Kept& c : kept_) ++firstOf_[c.a + 1];
  for (std::uint32_t a = 1; a < most; ++a) firstOf_[a] += firstOf_[a - 1];
}

void ContactMemory::giveBack(std::span<const Kept> contacts) {
  kept_.insert(kept_.end(), contacts.begin(), contacts.end());
  arrange();
}

void ContactMemory::save(StepperMemory& memory) const {
  memory.substep = substep_;
  memory.ballContacts.clear();
  memory.arenaContacts.clear();
  for (const Kept& c : kept_)
    (isBall(c.b) ? memory.ballContacts : memory.arenaContacts).push_back(c);
}

void ContactMemory::restore(const StepperMemory& memory) {
  substep_ = memory.substep;
  kept_ = memory.ballContacts;
  giveBack(memory.arenaContacts);
}

}  // namespace wells
