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

  /// Those of a ball a with balls follow each other, by b, and so do those with ground and wall.
  std::span<const Kept> contacts() const { return kept_; }

  /// What ball a's contacts had with balls, or with ground and wall: those that lasted.
  std::span<const Kept> ofBall(std::uint32_t a) const { return listOf(a, &Lists::balls); }
  std::span<const Kept> ofBallInArena(std::uint32_t a) const { return listOf(a, &Lists::arena); }

  /// What ball a's contact with b had; null: it did not last.
  const Kept* find(std::uint32_t a, std::uint32_t b) const;

  /// What rests needs the same force, so an impulse in proportion to the substep (s) at hand.
  double scaleTo(double substep) const { return substep_ == 0 ? 1 : substep / substep_; }

  /// Gives a contact of a step that begins, with substeps of `substep` s, the impulses that it had.
  void start(Contact& contact, double substep) const;

  // At the end of a step, with substeps of `substep` s: forget(substep), add() in the order of
  // contacts(), arrange(). What is not finite (beside a ball whose state stopped being so) is not
  // added.
  void forget(double substep);
  void add(const Contact& contact);
  void add(std::span<const Kept> contacts);
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
    arrange();
  }

  /// Adds all contacts of balls that were taken out, in their order.
  void giveBack(std::span<const Kept> contacts);

  void save(StepperMemory& memory) const;
  void restore(const StepperMemory& memory);

 private:
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  struct Lists {
    Range balls;
    Range arena;
  };
  std::span<const Kept> listOf(std::uint32_t a, Range Lists::*kind) const {
    if (a >= lists_.size()) return {};
    const Range& range = lists_[a].*kind;
    return std::span(kept_).subspan(range.first, range.count);
  }

  std::vector<Kept> kept_;
  std::vector<Lists> lists_;  // by ball a, up to the greatest
  double substep_ = 0;        // s; 0: nothing is kept
};

}  // namespace wells
