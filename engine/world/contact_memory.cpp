#include "world/contact_memory.h"

#include <algorithm>

namespace wells {
namespace {

std::vector<StepperMemory::Contact> saved(const std::vector<Contact>& contacts) {
  std::vector<StepperMemory::Contact> list;
  list.reserve(contacts.size());
  for (const Contact& c : contacts)
    list.push_back({c.a, c.b, c.impact, c.normalImpulse, c.tangentImpulse, c.rollingImpulse});
  return list;
}

std::vector<Contact> restored(const std::vector<StepperMemory::Contact>& list) {
  std::vector<Contact> contacts;
  contacts.reserve(list.size());
  for (const StepperMemory::Contact& c : list)
    contacts.push_back({.a = c.a,
                        .b = c.b,
                        .impact = c.impact,
                        .normalImpulse = c.normalImpulse,
                        .tangentImpulse = c.tangentImpulse,
                        .rollingImpulse = c.rollingImpulse});
  return contacts;
}

}  // namespace

void ContactMemory::keep(std::vector<Contact>& balls, std::vector<Contact>& arena, double substep) {
  std::swap(balls_, balls);
  std::swap(arena_, arena);
  substep_ = substep;
}

void ContactMemory::giveBack(std::span<const Contact> contacts) {
  for (const Contact& c : contacts) (isBall(c.b) ? balls_ : arena_).push_back(c);
  for (auto* list : {&balls_, &arena_}) std::ranges::sort(*list, isBefore);
}

void ContactMemory::save(StepperMemory& memory) const {
  memory.substep = substep_;
  memory.ballContacts = saved(balls_);
  memory.arenaContacts = saved(arena_);
}

void ContactMemory::restore(const StepperMemory& memory) {
  substep_ = memory.substep;
  balls_ = restored(memory.ballContacts);
  arena_ = restored(memory.arenaContacts);
}

}  // namespace wells
