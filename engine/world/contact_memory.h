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

  /// In no particular order.
  std::span<const Kept> contacts() const { return kept_; }

  /// Calls action(kept) for what each contact of ball a as the first of the two had.
  template <class Action>
  void forEachOf(std::uint32_t a, Action action) const {
    if (a >= firstOf_.size()) return;
    for (std::uint32_t n = firstOf_[a]; n != kNone; n = next_[n]) action(kept_[n]);
  }

  /// What ball a's contact with b had; null: it did not last.
  const Kept* find(std::uint32_t a, std::uint32_t b) const;

  /// What rests needs the same force, so an impulse in proportion to the substep (s) at hand.
  double scaleTo(double substep) const { return substep_ == 0 ? 1 : substep / substep_; }

  /// Gives a contact of a step that begins, with substeps of `substep` s, the impulses that it had.
  void start(Contact& contact, double substep) const;

  // At the end of a step, with substeps of `substep` s: forget(substep), add(), arrange(). What is
  // not finite (beside a ball whose state stopped being so) is not added.
  void forget(double substep);
  void add(const Contact& contact);
  void add(std::span<const Kept> contacts);
  void arrange();

  /// Takes out the contacts of balls for which mustGo(ball); calls taken(contact) for each.
  template <class MustGo, class Taken>
  void take(MustGo mustGo, Taken taken) {
    std::erase_if(kept_, [&](const Kept& c) {
      const bool goes = mustGo(c.a) || (isBall(c.b) && mustGo(c.b));
      if (goes) taken(c);
      return goes;
    });
    arrange();
  }

  /// Adds contacts that were taken out.
  void giveBack(std::span<const Kept> contacts);

  void save(StepperMemory& memory) const;
  void restore(const StepperMemory& memory);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<Kept> kept_;
  // The contacts of each ball a, chained.
  std::vector<std::uint32_t> firstOf_;  // by ball, and some more
  std::vector<std::uint32_t> next_;     // by contact
  double substep_ = 0;                  // s; 0: nothing is kept
};

}  // namespace wells
