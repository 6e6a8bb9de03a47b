#include "contacts/island_passes.h"

#include <algorithm>
#include <limits>

namespace wells {
namespace {

// The tangent plane has one mass: a tangent impulse of 1 changes the slip by so much more than a
// normal one changes the closing speed.
constexpr double kTangent = 1 + kSpinFactor;

double squared(double x) {
  return x * x;
}

Vec3 shortenedTo(double limit, const Vec3& v) {
  const double squared = squaredLength(v);
  return squared > limit * limit ? Vec3(limit / std::sqrt(squared) * v) : v;
}

Vec3 across(const Vec3& v, const Vec3& normal) {
  return v - dot(v, normal) * normal;
}

}  // namespace

void IslandPasses::solve(const Settings& settings, std::span<Contact* const> island, int most,
                         double solved, Balls& balls, const Ledger& ledger) {
  take(settings, island, balls);
  double changed = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most && changed > solved * solved; ++pass) {
    changed = 0;
    for (Row& row : rows_) {
      changed = std::max(changed, solvePush(settings.friction, row));
      if (settings.rollingResistance > 0)
        changed = std::max(changed, solveRolling(settings.rollingResistance, row));
    }
  }
  giveBack(balls, ledger);
}

std::uint32_t IslandPasses::bodyOf(std::uint32_t ball, double inverseMass, const Balls& balls) {
  if (!isBall(ball)) return kArena;
  if (const std::uint32_t known = number_[ball]; known < ballOf_.size() && ballOf_[known] == ball)
    return known;
  const auto body = static_cast<std::uint32_t>(bodies_.size());
  const double radius = balls.radius[ball];
  bodies_.push_back({balls.velocity[ball], radius * balls.spin[ball], inverseMass, 1 / radius});
  ballOf_.push_back(ball);
  return number_[ball] = body;
}

void IslandPasses::take(const Settings& settings, std::span<Contact* const> island,
                        const Balls& balls) {
  rows_.clear();
  bodies_.assign(1, {Vec3::Zero(), Vec3::Zero(), 0, 0});
  ballOf_.assign(1, kGround);
  number_.resize(balls.size(), kArena);
  for (Contact* c : island) {
    if (!c->acts) continue;
    const std::uint32_t a = bodyOf(c->a, c->inverseMassA, balls);
    const std::uint32_t b = bodyOf(c->b, c->inverseMassB, balls);
    const double inverse = c->inverseMassA + c->inverseMassB;
    double turning = 0;
    if (settings.rollingResistance > 0)
      for (const std::uint32_t i : {a, b}) {
        const Body& body = bodies_[i];
        turning += kSpinFactor * body.inverseMass * body.inverseRadius * body.inverseRadius;
      }
    const double mass = 1 / inverse;
    rows_.push_back({c, a, b, c->normal, mass, inverse, mass / kTangent, c->bounceSpeed, turning,
                     c->normalImpulse, c->tangentImpulse, c->rollingImpulse});
  }
}

// The normal impulse first, which bounds friction and changes nothing across the normal: so both
// are found from the same velocities.
double IslandPasses::solvePush(double friction, Row& row) {
  Body& a = bodies_[row.a];
  Body& b = bodies_[row.b];
  const Vec3 passing = a.velocity - b.velocity;
  const double closing = dot(passing, row.normal);
  const double normalImpulse =
      std::max(0.0, row.normalImpulse + row.normalMass * (closing + row.bounceSpeed));
  const double pressed = normalImpulse - row.normalImpulse;
  row.normalImpulse = normalImpulse;
  Vec3 impulse = -pressed * row.normal;
  double changed = squared(pressed * row.inverseNormalMass);
  if (friction > 0) {
    const Vec3 slip = passing - closing * row.normal + cross(a.surface + b.surface, row.normal);
    const Vec3 tangentImpulse =
        shortenedTo(friction * normalImpulse, row.tangentImpulse - row.tangentMass * slip);
    const Vec3 rubbed = tangentImpulse - row.tangentImpulse;
    row.tangentImpulse = tangentImpulse;
    impulse += rubbed;
    const Vec3 torque = kSpinFactor * cross(row.normal, rubbed);
    a.surface += a.inverseMass * torque;
    if (row.b != kArena) b.surface += b.inverseMass * torque;
    changed = std::max(changed, squaredLength(rubbed) * squared(kTangent * row.inverseNormalMass));
  }
  a.velocity += a.inverseMass * impulse;
  if (row.b != kArena) b.velocity -= b.inverseMass * impulse;
  return changed;
}

// Not within an impact: what the normal force of an instant does to the rolling is not modelled.
double IslandPasses::solveRolling(double resistance, Row& row) {
  if (row.contact->impact) return 0;
  Body& a = bodies_[row.a];
  Body& b = bodies_[row.b];
  const Vec3 rolling =
      across(a.inverseRadius * a.surface - b.inverseRadius * b.surface, row.normal);
  const Vec3 total = shortenedTo(resistance * row.normalImpulse,
                                 row.rollingImpulse - rolling / row.inverseTurning);
  const Vec3 change = total - row.rollingImpulse;
  row.rollingImpulse = total;
  a.surface += (kSpinFactor * a.inverseMass * a.inverseRadius) * change;
  b.surface -= (kSpinFactor * b.inverseMass * b.inverseRadius) * change;
  return squaredLength(change) * squared(row.inverseTurning / a.inverseRadius);
}

// What the impulses did to the energy is told by the balls that they moved.
void IslandPasses::giveBack(Balls& balls, const Ledger& ledger) const {
  for (std::size_t n = 1; n < bodies_.size(); ++n) {
    const Body& body = bodies_[n];
    const std::uint32_t i = ballOf_[n];
    const double radius = balls.radius[i];
    const Vec3 surface = radius * balls.spin[i];
    const Vec3 gained = body.surface - surface;  // exactly 0 where nothing turns it
    if (ledger)
      ledger.books->contacts +=
          (dot(body.velocity - balls.velocity[i], body.velocity + balls.velocity[i]) +
           kInertiaFactor * dot(gained, body.surface + surface)) /
          (2 * body.inverseMass);
    balls.velocity[i] = body.velocity;
    balls.spin[i] += body.inverseRadius * gained;
  }
  for (const Row& row : rows_) {
    Contact& c = *row.contact;
    if (ledger && isBall(c.b))
      ledger.books->shifts.angular -=
          c.gap * cross(c.normal, row.tangentImpulse - c.tangentImpulse);
    c.normalImpulse = row.normalImpulse;
    c.tangentImpulse = row.tangentImpulse;
    c.rollingImpulse = row.rollingImpulse;
  }
}

}  // namespace wells
