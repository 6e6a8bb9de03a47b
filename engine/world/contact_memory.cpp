#include "world/contact_memory.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace wells {
namespace {

/// Not so beside a ball whose state stopped being finite.
bool isFiniteImpulse(const StepperMemory::Contact& c) {
  return std::isfinite(c.normalImpulse) && isFinite(c.tangentImpulse) && isFinite(c.rollingImpulse);
}

}  // namespace

const ContactMemory::Kept* ContactMemory::find(std::uint32_t a, std::uint32_t b) const {
  const Kept* found = nullptr;
  forEachOf(a, [&](const Kept& kept) {
    if (kept.b == b) found = &kept;
  });
  return found;
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
  const Kept kept{c.a, c.b, c.normalImpulse, c.tangentImpulse, c.rollingImpulse};
  add({&kept, 1});
}

void ContactMemory::add(std::span<const Kept> contacts) {
  for (const Kept& contact : contacts)
    if (isFiniteImpulse(contact)) kept_.push_back(contact);
}

void ContactMemory::arrange() {
  firstOf_.clear();
  next_.reserve(kept_.capacity());
  next_.resize(kept_.size());
  for (std::uint32_t n = 0; n < kept_.size(); ++n) {
    const std::uint32_t a = kept_[n].a;
    if (a >= firstOf_.size()) firstOf_.resize(std::bit_ceil(a + 1), kNone);
    next_[n] = std::exchange(firstOf_[a], n);
  }
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
  for (auto* contacts : {&memory.ballContacts, &memory.arenaContacts})
    std::ranges::sort(
        *contacts, [](const Kept& x, const Kept& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
}

void ContactMemory::restore(const StepperMemory& memory) {
  substep_ = memory.substep;
  kept_.clear();
  for (const auto* contacts : {&memory.ballContacts, &memory.arenaContacts}) add(*contacts);
  arrange();
}

}  // namespace wells
