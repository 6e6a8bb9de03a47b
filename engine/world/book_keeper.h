// Sums what the parts of a step booked, and books what happened to the world between two steps.
#pragma once

#include "forces/field.h"
#include "state/books.h"
#include "state/world.h"
#include "world/measures.h"

namespace wells {

class BookKeeper {
 public:
  void open() { isOpen_ = true; }

  /// Null until opened.
  const Books* books() const { return isOpen_ ? &books_ : nullptr; }

  /// The field of the step that begins. What changed since the last endStep() is booked: fields
  /// that jumped by what they do to the balls, the rest as a change from outside.
  void beginStep(const World& world, const Field& field);

  /// The field of the step that ended, and what its parts booked.
  void endStep(const World& world, const Field& field, const Books& step);

 private:
  /// Of all balls whose states are finite.
  struct Sums : Mechanics {
    std::int64_t balls = 0;
  };
  /// What a step did to balls that nobody books: ghosts that drift, and balls whose state stopped
  /// being finite.
  static Books unbooked(const Sums& start, const Sums& end, const Books& step);
  static Sums sumsOf(const World& world, const Field& field, double t);

  bool isOpen_ = false;
  bool hasStepped_ = false;
  Books books_;
  Books between_;  // what changed before the step at hand
  Field lastField_;
  double lastDt_ = 0;  // s
  Sums last_;          // at the end of the last step, in its field
  Sums start_;         // of the step at hand
};

}  // namespace wells
