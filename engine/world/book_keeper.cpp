#include "world/book_keeper.h"

#include <cmath>

namespace wells {

BookKeeper::Sums BookKeeper::sumsOf(const World& world, const Field& field, double t) {
  Sums sums;
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    if (!isFinite(world.balls.state(i))) continue;
    ++sums.balls;
    addMechanics(world, field, t, i, sums);
  }
  return sums;
}

Books BookKeeper::unbooked(const Sums& start, const Sums& end, const Books& step) {
  Books rest;
  rest.outside = end.energy() - start.energy() - step.energy();
  rest.changes.linear = end.momentum - start.momentum - step.impulse();
  rest.changes.angular = end.angularMomentum - start.angularMomentum - step.angularImpulse();
  return rest;
}

void BookKeeper::beginStep(const World& world, const Field& field) {
  between_ = {};
  if (!isOpen_) return;
  start_ = sumsOf(world, field, 0);
  if (!hasStepped_) return;
  // In the old field, so that a change of state and a change of field do not mix.
  const Sums before = sumsOf(world, lastField_, lastDt_);
  between_.outside = before.energy() - last_.energy();
  between_.wells = start_.energy() - before.energy();
  between_.changes.linear = before.momentum - last_.momentum;
  between_.changes.angular = before.angularMomentum - last_.angularMomentum;
}

void BookKeeper::endStep(const World& world, const Field& field, const Books& step) {
  if (!isOpen_) return;
  books_ += between_;
  lastField_ = field;
  lastDt_ = world.settings.dt;
  last_ = sumsOf(world, field, lastDt_);
  const Books booked = std::isfinite(step.energy()) ? step : Books{};
  books_ += booked;
  if (!world.roles.empty() || last_.balls != start_.balls)
    books_ += unbooked(start_, last_, booked);
  hasStepped_ = true;
}

}  // namespace wells
