// The impulses that contacts ended a step with, for the next step to start from.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "contacts/contact.h"
#include "state/stepper.h"

namespace wells {

class ContactMemory {
 public:
  bool isEmpty() const { return substep_ == 0; }

  /// Takes the contacts of a step that ended (the lists hold anything afterwards); substep: s, in
  /// which their impulses arose.
  void keep(std::vector<Contact>& balls, std::vector<Contact>& arena, double substep);

  /// Gives the contacts of a step that begins, with substeps of `substep` s, the impulses that they
  /// had; what rests needs the same force, so an impulse in proportion. Calls appeared(contact) for
  /// contacts between balls that were not there.
  template <class Appeared>
  void start(std::vector<Contact>& balls, std::vector<Contact>& arena, double substep,
             Appeared appeared) const {
    const double scale = isEmpty() ? 1 : substep / substep_;
    inherit(balls_, scale, balls, appeared);
    inherit(arena_, scale, arena, [](const Contact&) {});
  }

  std::span<const Contact> balls() const { return balls_; }
  std::span<const Contact> arena() const { return arena_; }

  /// Takes out the contacts of balls for which mustGo(ball); calls taken(contact) for each, those
  /// between balls first, in order.
  template <class MustGo, class Taken>
  void take(MustGo mustGo, Taken taken) {
    for (auto* contacts : {&balls_, &arena_})
      std::erase_if(*contacts, [&](const Contact& c) {
        const bool goes = mustGo(c.a) || (isBall(c.b) && mustGo(c.b));
        if (goes) taken(c);
        return goes;
      });
  }

  /// Adds contacts that were taken out, in any order.
  void giveBack(std::span<const Contact> contacts);

  void save(StepperMemory& memory) const;
  void restore(const StepperMemory& memory);

 private:
  template <class Appeared>
  static void inherit(const std::vector<Contact>& old, double scale, std::vector<Contact>& contacts,
                      Appeared appeared) {
    auto match = old.begin();
    for (Contact& c : contacts) {
      while (match != old.end() && isBefore(*match, c)) ++match;
      if (match == old.end() || isBefore(c, *match) || !isFiniteImpulse(*match)) {
        appeared(c);
        continue;
      }
      c.impact = match->impact;
      c.normalImpulse = scale * match->normalImpulse;
      c.tangentImpulse = scale * match->tangentImpulse;
      c.rollingImpulse = scale * match->rollingImpulse;
    }
  }

  /// Not so beside a ball whose state stopped being finite.
  static bool isFiniteImpulse(const Contact& c) {
    return std::isfinite(c.normalImpulse) && isFinite(c.tangentImpulse) &&
           isFinite(c.rollingImpulse);
  }

  std::vector<Contact> balls_;
  std::vector<Contact> arena_;
  double substep_ = 0;  // s; 0: nothing is kept
};

}  // namespace wells
