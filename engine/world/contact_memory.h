// The impulses that contacts ended a step with, for the next step to start from: those of contacts
// that last. The impulse of an impact says nothing about the next substep's.
#pragma once

#include <span>
#include <vector>

#include "contacts/contact.h"
#include "state/stepper.h"

namespace wells {

class ContactMemory {
 public:
  using Kept = StepperMemory::Contact;

  /// True before any step.
  bool isEmpty() const { return substep_ == 0; }

  /// By (a, b), those with ground and wall included.
  std::span<const Kept> contacts() const { return kept_; }

  /// What ball a's contact with b had; null: it did not last, or is not finite (beside a ball whose
  /// state stopped being so).
  const Kept* find(std::uint32_t a, std::uint32_t b) const;

  /// What rests needs the same force, so an impulse in proportion to the substep (s) at hand.
  double scaleTo(double substep) const { return isEmpty() ? 1 : substep / substep_; }

  /// Gives a contact of a step that begins, with substeps of `substep` s, the impulses that it had.
  void start(Contact& contact, double substep) const;

  // At the end of a step, with substeps of `substep` s: forget(substep), add() for each contact in
  // any order, arrange().
  void forget(double substep);
  void add(const Contact& contact);
  void add(const Kept& contact) { kept_.push_back(contact); }
  /// Puts them in order.
  void arrange();

  /// Takes out the contacts of balls for which mustGo(ball); calls taken(contact) for each, in
  /// order.
  template <class MustGo, class Taken>
  void take(MustGo mustGo, Taken taken) {
    std::erase_if(kept_, [&](const Kept& c) {
      const bool goes = mustGo(c.a) || (isBall(c.b) && mustGo(c.b));
      if (goes) taken(c);
      return goes;
    });
    index();
  }

  /// Adds contacts that were taken out, in any order.
  void giveBack(std::span<const Kept> contacts);

  void save(StepperMemory& memory) const;
  void restore(const StepperMemory& memory);

 private:
  void index();

  std::vector<Kept> kept_;
  std::vector<Kept> unsorted_;          // scratch
  std::vector<std::uint32_t> firstOf_;  // by ball a, up to the greatest: of its contacts
  double substep_ = 0;                  // s; 0: nothing is kept
};

}  // namespace wells
