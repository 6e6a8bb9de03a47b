// The impulses that contacts ended a step with, for the next step to start from.
#pragma once

#include <cstddef>
#include <vector>

#include "contacts/contact.h"
#include "state/stepper.h"

namespace wells {

class ContactMemory {
 public:
  bool isEmpty() const { return substep_ == 0; }

  /// Keeps the contacts of a step that ended; substep: s, in which their impulses arose.
  void keep(const std::vector<Contact>& balls, const std::vector<Contact>& arena, double substep);

  /// Gives the contacts of a step that begins, with substeps of `substep` s, the impulses that they
  /// had; what rests needs the same force, so an impulse in proportion. Calls appeared(contact) for
  /// contacts between balls that were not there.
  template <class Appeared>
  void start(std::vector<Contact>& balls, std::vector<Contact>& arena, double substep,
             Appeared appeared) const {
    const double scale = isEmpty() ? 1 : substep / substep_;
    take(balls_, scale, balls, appeared);
    take(arena_, scale, arena, [](const Contact&) {});
  }

  void save(StepperMemory& memory) const;
  void restore(const StepperMemory& memory);

 private:
  using Kept = StepperMemory::Contact;

  template <class Appeared>
  static void take(const std::vector<Kept>& old, double scale, std::vector<Contact>& contacts,
                   Appeared appeared) {
    std::size_t match = 0;
    for (Contact& c : contacts) {
      while (match < old.size() && isBefore({.a = old[match].a, .b = old[match].b}, c)) ++match;
      if (match == old.size() || old[match].a != c.a || old[match].b != c.b) {
        appeared(c);
        continue;
      }
      c.impact = old[match].impact;
      c.normalImpulse = scale * old[match].normalImpulse;
      c.tangentImpulse = scale * old[match].tangentImpulse;
    }
  }

  std::vector<Kept> balls_;
  std::vector<Kept> arena_;
  double substep_ = 0;  // s; 0: nothing is kept
};

}  // namespace wells
