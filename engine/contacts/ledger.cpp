#include "contacts/ledger.h"

#include "contacts/corner_motion.h"
#include "contacts/held_motion.h"

namespace wells {
namespace {

/// Work, impulse and torque per mass and second.
struct Rates {
  double drag = 0;
  double wells = 0;
  double friction = 0;
  Vec3 pull = Vec3::Zero();    // of the fields and of drag
  Vec3 torque = Vec3::Zero();  // of the pull, about the centre
  ImpulseBook ground;          // of its force, in the corner
};

Rates operator+(const Rates& a, const Rates& b) {
  return {a.drag + b.drag,
          a.wells + b.wells,
          a.friction + b.friction,
          a.pull + b.pull,
          a.torque + b.torque,
          {a.ground.linear + b.ground.linear, a.ground.angular + b.ground.angular}};
}
Rates operator*(double s, const Rates& a) {
  return {s * a.drag, s * a.wells,  s * a.friction,
          s * a.pull, s * a.torque, {s * a.ground.linear, s * a.ground.angular}};
}

/// The work of friction on both, and the force of the ground.
void addCorner(const Ledger& ledger, const PathModel& model, const Path& there, Rates& rates) {
  const CornerMotion motion(model, there);
  const Cornered& now = motion.start();
  const CornerForces on = motion.forcesOn(now, there.start);
  rates.friction = dot(on.wallFriction, {now.wallSlip, now.across}) +
                   dot(on.groundFriction, {now.groundSlip, now.across});
  const Vec3& place = there.state.position;
  const Frame frame = Surface(*model.arena, kWall, place, there.radius).at({}).frame;
  rates.ground.linear =
      on.groundFriction.x * frame.x + on.ground * frame.y - on.groundFriction.y * frame.normal;
  rates.ground.angular = cross(place - there.radius * frame.y - ledger.center, rates.ground.linear);
}

Rates ratesOf(const Ledger& ledger, const PathModel& model, const Path& path, const BallState& now,
              double t) {
  Rates rates;
  const double k = dragRate(model.drag);
  rates.drag = -k * squaredLength(now.velocity);
  rates.wells = potentialRate(*model.field, now.position, t);
  rates.pull = acceleration(*model.field, now.position, t) - k * now.velocity;
  rates.torque = cross(now.position - ledger.center, rates.pull);
  if (path.motion == Motion::Flying) return rates;
  const Path there{now, t, path.radius, path.motion, path.surface, path.rolling};
  if (path.surface == kCorner) {
    addCorner(ledger, model, there, rates);
    return rates;
  }
  const bool isSlipping = path.motion == Motion::Sliding || path.motion == Motion::Skidding;
  const bool isResisted = model.rollingResistance > 0 &&
                          (path.motion == Motion::Sliding || path.motion == Motion::Rolling);
  if (!isSlipping && !isResisted) return rates;
  const double pressing = loadOn(model, there, t).pressing;
  if (isSlipping) rates.friction = -model.friction * pressing * length(slipOf(model, there));
  if (isResisted)
    rates.friction -=
        model.rollingResistance * pressing * length(cross(now.spin, normalOf(model, there)));
  return rates;
}

// Per mass.
double kineticOf(const BallState& now, double radius) {
  return 0.5 *
         (squaredLength(now.velocity) + kInertiaFactor * radius * radius * squaredLength(now.spin));
}

double energyOf(const PathModel& model, const BallState& now, double radius, double t) {
  return kineticOf(now, radius) + potentialAt(*model.field, now.position, model.arena->center, t);
}

Vec3 angularOf(const Ledger& ledger, const BallState& now, double radius) {
  return cross(now.position - ledger.center, now.velocity) +
         kInertiaFactor * radius * radius * now.spin;
}

/// In the corner, what the ground did not give is the wall's.
ImpulseBook& bookOf(Books& books, std::uint32_t surface) {
  return surface == kGround ? books.ground : books.wall;
}

struct Moment {
  BallState state;
  double time;
};

/// One stretch of the path, by Simpson's rule.
void bookStretch(const Ledger& ledger, const PathModel& model, const Path& path, double mass,
                 const Moment& first, const Moment& middle, const Moment& last) {
  Books& books = *ledger.books;
  const double h = last.time - first.time;
  const auto rates = [&](const Moment& m) { return ratesOf(ledger, model, path, m.state, m.time); };
  const Rates sum = (h / 6) * (rates(first) + 4 * rates(middle) + rates(last));
  const double gained = energyOf(model, last.state, path.radius, last.time) -
                        energyOf(model, first.state, path.radius, first.time);
  books.drag += mass * sum.drag;
  books.wells += mass * sum.wells;
  books.friction += mass * sum.friction;
  books.flight += mass * (gained - sum.drag - sum.wells - sum.friction);

  const Vec3 push = mass * (last.state.velocity - first.state.velocity);
  const Vec3 turn = mass * (angularOf(ledger, last.state, path.radius) -
                            angularOf(ledger, first.state, path.radius));
  if (path.motion == Motion::Flying) {
    books.fields.linear += push;
    books.fields.angular += turn;
    return;
  }
  books.fields.linear += mass * sum.pull;
  books.fields.angular += mass * sum.torque;
  ImpulseBook& book = bookOf(books, path.surface);
  book.linear += push - mass * (sum.pull + sum.ground.linear);
  book.angular += turn - mass * (sum.torque + sum.ground.angular);
  books.ground.linear += mass * sum.ground.linear;
  books.ground.angular += mass * sum.ground.angular;
}

}  // namespace

void bookTurnedNormal(const Ledger& ledger, const Contact& c, const Balls& balls) {
  if (c.normalImpulse == 0) return;
  const Vec3 d = balls.position[c.b] - balls.position[c.a];
  const Vec3 impulse = c.tangentImpulse - c.normalImpulse * c.normal;
  ledger.books->shifts.angular += cross(length(d) * c.normal - d, impulse);
}

void bookArena(const Ledger& ledger, const Contact& c, const Vec3& impulse, const Balls& balls) {
  ImpulseBook& book = bookOf(*ledger.books, c.b);
  const Vec3 place = balls.position[c.a] + balls.radius[c.a] * c.normal;
  book.linear += impulse;
  book.angular += cross(place - ledger.center, impulse) + c.rollingImpulse;
}

void bookPath(const Ledger& ledger, const PathModel& model, const Path& path, double mass,
              double until) {
  // A flight is as good from any of its stretches on; what a surface holds is not.
  Path from = path;
  const auto moment = [&](double t) -> Moment { return {stateAt(model, from, t), t}; };
  const double stretch = model.field->stretch;
  Moment first{path.state, path.start};
  while (first.time < until) {
    const double next =
        until - first.time > stretch * (1 + kNoRemainder) ? first.time + stretch : until;
    const Moment last = moment(next);
    if (!isFinite(last.state)) return;
    bookStretch(ledger, model, path, mass, first, moment(first.time + (next - first.time) / 2),
                last);
    first = last;
    if (path.motion == Motion::Flying) from = {last.state, last.time, path.radius};
  }
}

void bookHold(const Ledger& ledger, const BallState& before, const Path& held, double mass) {
  Books& books = *ledger.books;
  books.friction += mass * (kineticOf(held.state, held.radius) - kineticOf(before, held.radius));
  ImpulseBook& book = bookOf(books, held.surface);
  book.linear += mass * (held.state.velocity - before.velocity);
  book.angular +=
      mass * (angularOf(ledger, held.state, held.radius) - angularOf(ledger, before, held.radius));
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
