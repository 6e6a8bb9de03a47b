#include "contacts/ledger.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace wells {
namespace {

/// Work, impulse and torque per mass and second.
struct Rates {
  double drag = 0;
  double wells = 0;
  double friction = 0;
  Vec3 pull = Vec3::Zero();    // of the fields and of drag
  Vec3 torque = Vec3::Zero();  // of the pull, about the centre
};

Rates operator+(const Rates& a, const Rates& b) {
  return {a.drag + b.drag, a.wells + b.wells, a.friction + b.friction, a.pull + b.pull,
          a.torque + b.torque};
}
Rates operator*(double s, const Rates& a) {
  return {s * a.drag, s * a.wells, s * a.friction, s * a.pull, s * a.torque};
}

Rates ratesOf(const Ledger& ledger, const PathModel& model, const Path& path, const BallState& now,
              double t) {
  Rates rates;
  const double k = model.drag == 1 ? 0 : -naturalLogarithm(model.drag);
  rates.drag = -k * squaredLength(now.velocity);
  rates.wells = potentialRate(*model.field, now.position, t);
  rates.pull = acceleration(*model.field, now.position, t) - k * now.velocity;
  rates.torque = cross(now.position - ledger.center, rates.pull);
  if (path.motion == Motion::Sliding) {
    const Vec3 slip(now.velocity.x() + path.radius * now.spin.z(), 0,
                    now.velocity.z() - path.radius * now.spin.x());
    rates.friction = model.friction * rates.pull.y() * length(slip);  // pull.y < 0 presses
  }
  return rates;
}

double energyOf(const PathModel& model, const BallState& now, double radius, double t) {
  return 0.5 * (squaredLength(now.velocity) +
                kInertiaFactor * radius * radius * squaredLength(now.spin)) +
         potentialAt(*model.field, now.position, model.arena->center, t);
}

Vec3 angularOf(const Ledger& ledger, const BallState& now, double radius) {
  return cross(now.position - ledger.center, now.velocity) +
         kInertiaFactor * radius * radius * now.spin;
}

/// One stretch, by Simpson's rule.
void bookStretch(const Ledger& ledger, const PathModel& model, const Path& path, double mass,
                 double until, const BallState& end) {
  Books& books = *ledger.books;
  const double h = until - path.start;
  const double middle = path.start + h / 2;
  const Rates sum =
      (h / 6) * (ratesOf(ledger, model, path, path.state, path.start) +
                 4 * ratesOf(ledger, model, path, stateAt(model, path, middle), middle) +
                 ratesOf(ledger, model, path, end, until));
  const double gained = energyOf(model, end, path.radius, until) -
                        energyOf(model, path.state, path.radius, path.start);
  books.drag += mass * sum.drag;
  books.wells += mass * sum.wells;
  books.friction += mass * sum.friction;
  books.flight += mass * (gained - sum.drag - sum.wells - sum.friction);

  const Vec3 push = mass * (end.velocity - path.state.velocity);
  const Vec3 turn =
      mass * (angularOf(ledger, end, path.radius) - angularOf(ledger, path.state, path.radius));
  if (path.motion == Motion::Flying) {
    books.fields.linear += push;
    books.fields.angular += turn;
    return;
  }
  books.fields.linear += mass * sum.pull;
  books.fields.angular += mass * sum.torque;
  books.ground.linear += push - mass * sum.pull;
  books.ground.angular += turn - mass * sum.torque;
}

}  // namespace

void bookArena(const Ledger& ledger, const Contact& c, const Vec3& impulse, const Balls& balls) {
  ImpulseBook& book = c.b == kGround ? ledger.books->ground : ledger.books->wall;
  const Vec3 place = balls.position[c.a] + balls.radius[c.a] * c.normal;
  book.linear += impulse;
  book.angular += cross(place - ledger.center, impulse);
}

void bookPath(const Ledger& ledger, const PathModel& model, const Path& path, double mass,
              double until) {
  Path rest = path;
  while (rest.start < until) {
    const double next = until - rest.start > model.field->stretch * (1 + 1e-9)
                            ? rest.start + model.field->stretch
                            : until;
    const BallState end = stateAt(model, rest, next);
    bookStretch(ledger, model, rest, mass, next, end);
    rest.state = end;
    rest.start = next;
  }
}

Placement placementOf(const Ledger& ledger, const Field& field, double t,
                      std::span<const std::uint32_t> chosen, const Balls& balls) {
  Placement sum;
  for (const std::uint32_t i : chosen) {
    sum.potential += balls.mass[i] * potentialAt(field, balls.position[i], ledger.center, t);
    sum.angular += balls.mass[i] * cross(balls.position[i] - ledger.center, balls.velocity[i]);
  }
  return sum;
}

}  // namespace wells
