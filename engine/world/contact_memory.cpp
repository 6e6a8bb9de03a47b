#include "world/contact_memory.h"

namespace wells {
namespace {

void copy(const std::vector<Contact>& contacts, std::vector<StepperMemory::Contact>& kept) {
  kept.clear();
  for (const Contact& c : contacts)
    if (std::isfinite(c.normalImpulse) && isFinite(c.tangentImpulse))
      kept.push_back({c.a, c.b, c.impact, c.normalImpulse, c.tangentImpulse});
}

}  // namespace

void ContactMemory::keep(const std::vector<Contact>& balls, const std::vector<Contact>& arena,
                         double substep) {
  copy(balls, balls_);
  copy(arena, arena_);
  substep_ = substep;
}

void ContactMemory::save(StepperMemory& memory) const {
  memory.substep = substep_;
  memory.ballContacts = balls_;
  memory.arenaContacts = arena_;
}

void ContactMemory::restore(const StepperMemory& memory) {
  substep_ = memory.substep;
  balls_ = memory.ballContacts;
  arena_ = memory.arenaContacts;
}

}  // namespace wells
