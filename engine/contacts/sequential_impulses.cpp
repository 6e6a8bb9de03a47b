#include "contacts/sequential_impulses.h"

#include <algorithm>
#include <limits>

#include "contacts/lasting_force.h"
#include "contacts/partners.h"
#include "contacts/substep_rules.h"

namespace wells {
namespace {

/// m; of the coordinates that a gap is made of.
double sizeOf(const Arena& arena, const Balls& balls, const Contact& c) {
  return length(balls.position[c.a]) + length(arena.center) + arena.radius;
}

template <class Partner>
constexpr double kShareOut = kPushOut;
template <>
constexpr double kShareOut<ArenaPartner> = kPushOutOfArena;

// How deep a ball may be that leaves fast, in radii.
template <class Partner>
constexpr double kDeepest = std::numeric_limits<double>::infinity();
template <>
constexpr double kDeepest<ArenaPartner> = kDeepestInArena;

// An island moves, and does not rest or nearly so, where the centres of two of its balls pass each
// other faster than this many times the speed which forces gave one of them within the substep: of
// what rests, it is at most that.
constexpr double kMoving = 2;

/// The normal half-way through the substep: there a force that lasted acted on the mean. With it,
/// what rolls over another ball keeps its energy to second order, and two balls their angular
/// momentum.
template <class Partner>
void turnToMiddle(const Arena& arena, double h, const Balls& balls, Contact& c) {
  const Vec3 middle = Partner::across(arena, balls.position.data(), c) -
                      (h / 2) * Partner::acrossRate(balls.velocity.data(), c);
  const double size = length(middle);
  if (size > 0) c.normal = middle / size;
}

/// m/s that the forces of the substep gave the two balls.
struct Pulled {
  Vec3 a;
  Vec3 b;

  /// Of one ball: the other may be held, so this is what they can explain of a speed.
  double along(const Vec3& normal) const {
    return std::max(std::abs(dot(a, normal)), std::abs(dot(b, normal)));
  }
  double squared() const { return std::max(squaredLength(a), squaredLength(b)); }
};

template <class Partner>
Pulled pulledSpeeds(const Vec3* velocityBefore, const Balls& balls, const Contact& c) {
  const Vec3* const velocity = balls.velocity.data();
  return {velocity[c.a] - velocityBefore[c.a],
          Partner::velocity(velocity, c) - Partner::velocity(velocityBefore, c)};
}

/// What does not touch, or bounced, says nothing about the next substep's impulses.
void forgetImpulses(Contact& c) {
  c.normalImpulse = 0;
  c.tangentImpulse.setZero();
  c.rollingImpulse.setZero();
}

void letGo(Contact& c) {
  c.acts = false;
  c.impact = false;
  forgetImpulses(c);
}

/// Geometry, and whether the contact acts: where it touches; where it rested in the substep before,
/// for two balls that roll on each other part a little in every flight; and where it is so close
/// and slow that forces close it within the substep.
template <class Partner>
void findTouch(const Arena& arena, double h, const Vec3* velocityBefore, const Balls& balls,
               Contact& c) {
  const double near = kNear * balls.radius[c.a];
  c.isSmall = false;
  c.isSolved = false;
  // Most are. What rounding leaves of a closed gap is surely not more.
  if (Partner::isFurther(arena, balls, c, 2 * near)) return letGo(c);
  Partner::touch(arena, balls, c);
  const Vec3* const velocity = balls.velocity.data();
  const Vec3 passing = velocity[c.a] - Partner::velocity(velocity, c);
  const double closing = dot(passing, c.normal);
  const Pulled pulls = pulledSpeeds<Partner>(velocityBefore, balls, c);
  const double pulled = pulls.along(c.normal);
  c.isSlow = closing <= kRestFactor * pulled;
  const double fall = pulled * h / 2;
  c.isPulled = pulled > 0;
  c.isCoarse = fall > near;
  c.isMoving = squaredLength(passing) > kMoving * kMoving * pulls.squared();
  c.restedImpulse = c.impact || c.isCoarse || c.gap > near ? 0 : c.normalImpulse;
  c.acts = c.gap <= kClosedGap * sizeOf(arena, balls, c) || c.restedImpulse > 0 ||
           (!c.isCoarse && c.isSlow && c.gap <= fall);
  if (!c.acts) letGo(c);
}

/// m/s, by which the contact shall open; < 0: may close. From the closing speeds after flight.
template <class Partner>
double bounceSpeed(double elasticity, double h, const Balls& balls, const Contact& c) {
  const bool rested = c.restedImpulse > 0;
  if (c.impact) return elasticity * c.closingFlown;
  // Along the normal half-way, what turns parts at the start as fast as it closes at the end. Where
  // overlap is left, no gap says so.
  if (rested && !c.isSmall) {
    const double speed =
        length(balls.velocity[c.a]) + length(Partner::velocity(balls.velocity.data(), c));
    return std::min(0.0, withoutNoise(c.closingFlown - c.builtUp, speed));
  }
  // What has not closed yet may do so within the next substep, and no faster. A force that lasts
  // will have lifted it again by half of what its speed built up.
  const double ahead = rested ? c.gap + std::max(0.0, c.builtUp) * h / 2 : c.gap;
  const bool isOpen = ahead > kClosedGap * (length(balls.position[c.a]) + balls.radius[c.a]);
  return isOpen ? -ahead / h : 0;
}

/// Masses and the bounce, from the state before any impulse of this substep. In large islands,
/// whose contacts are left some overlap, they act only where they touch.
template <class Partner>
void prepare(const Settings& settings, const Arena& arena, double h, const Vec3* velocityBefore,
             const Balls& balls, Contact& c) {
  if (!c.isSmall) c.acts = c.gap <= 0;
  const bool wasImpact = c.impact;
  const bool rested = c.isSmall && c.restedImpulse > 0;
  c.impact = false;
  if (c.acts) {
    if (c.restedImpulse > 0) turnToMiddle<Partner>(arena, h, balls, c);
    const double closing = closingSpeed<Partner>(balls.velocity.data(), c);
    const double speed =
        length(balls.velocity[c.a]) + length(Partner::velocity(balls.velocity.data(), c));
    c.closingFlown = closing;
    c.builtUp = withoutNoise(closing - closingSpeed<Partner>(velocityBefore, c), speed);
    c.impact = !rested && !c.isSlow;
    c.bounceSpeed = bounceSpeed<Partner>(settings.elasticity, h, balls, c);
    c.inverseMassA = 1 / balls.mass[c.a];
    c.inverseMassB = Partner::inverseMass(balls, c);
  }
  if (!c.acts || c.impact || wasImpact) forgetImpulses(c);
}

template <class Partner>
void pushApart(Balls& balls, const Contact& c, double impulse, const Ledger& ledger) {
  if (ledger) bookNormal(ledger, c, impulse, closingSpeed<Partner>(balls.velocity.data(), c));
  applyImpulse<Partner>(balls, c, -impulse * c.normal);
}

template <class Partner>
void rub(Balls& balls, const Contact& c, const Vec3& impulse, const Ledger& ledger) {
  if (ledger) bookTangent(ledger, c, impulse, slipVelocity<Partner>(balls, c));
  applyTangentImpulse<Partner>(balls, c, impulse);
}

template <class Partner>
void brake(Balls& balls, const Contact& c, const Vec3& torque, const Ledger& ledger) {
  if (ledger)
    bookRolling(ledger, torque, rollingVelocity<Partner>(balls, c),
                inverseTurningInertia<Partner>(balls, c));
  applyTorqueImpulse<Partner>(balls, c, torque);
}

template <class Partner>
void warmStart(Balls& balls, Contact& c, const Ledger& ledger) {
  if (c.normalImpulse == 0) return;
  c.tangentImpulse -= dot(c.tangentImpulse, c.normal) * c.normal;  // the normal has turned
  pushApart<Partner>(balls, c, c.normalImpulse, ledger);
  rub<Partner>(balls, c, c.tangentImpulse, ledger);
  if (c.rollingImpulse.isZero(0)) return;
  c.rollingImpulse -= dot(c.rollingImpulse, c.normal) * c.normal;
  brake<Partner>(balls, c, c.rollingImpulse, ledger);
}

template <class Partner>
void give(const DirectSolver::Impulse& total, Balls& balls, Contact& c, const Ledger& ledger) {
  pushApart<Partner>(balls, c, total.normal - c.normalImpulse, ledger);
  rub<Partner>(balls, c, total.tangent - c.tangentImpulse, ledger);
  c.normalImpulse = total.normal;
  c.tangentImpulse = total.tangent;
  if (!total.rolling.isZero(0) || !c.rollingImpulse.isZero(0))
    brake<Partner>(balls, c, total.rolling - c.rollingImpulse, ledger);
  c.rollingImpulse = total.rolling;
  c.isSolved = true;
}

bool anyMoves(std::span<Contact* const> island) {
  return std::ranges::any_of(island, [](const Contact* c) { return c->isMoving; });
}

/// Where no force acts nothing lasts, and where substeps are too coarse nothing can be told to.
void findSmallIslands(const ContactLists& contacts, std::size_t ballCount,
                      TouchingIslands& islands) {
  islands.find(contacts.balls, contacts.arena, ballCount);
  for (std::size_t n = 0; n < islands.count(); ++n) {
    const auto island = islands.contacts(n);
    const bool isSmall =
        island.size() <= kMostDirect && (island.size() <= kMostDirectMoving || !anyMoves(island)) &&
        std::ranges::any_of(island, [](const Contact* c) { return c->isPulled; }) &&
        std::ranges::none_of(island, [](const Contact* c) { return c->isCoarse; });
    for (Contact* c : island) c->isSmall = isSmall;
  }
}

bool anyImpact(std::span<Contact* const> island) {
  return std::ranges::any_of(island, [](const Contact* c) { return c->impact; });
}

/// All impulses of an island at once. False: not found, and nothing has changed.
bool solveDirectly(const Settings& settings, std::span<Contact* const> island, Balls& balls,
                   DirectSolver& solver, const Ledger& ledger) {
  if (!solver.solve(settings.friction, island, balls, settings.rollingResistance)) return false;
  for (std::size_t i = 0; i < island.size(); ++i)
    withPartner(*island[i], [&]<class Partner>() {
      give<Partner>(solver.impulses()[i], balls, *island[i], ledger);
    });
  shareTogether(island, balls);
  return true;
}

void solveByPasses(const Settings& settings, std::span<Contact* const> island, Balls& balls,
                   IslandPasses& passes, const Ledger& ledger) {
  double built = 0;
  for (const Contact* c : island) built = std::max(built, c->acts ? c->builtUp : 0);
  const int most = anyImpact(island) || anyMoves(island)
                       ? settings.iterations
                       : std::max(settings.iterations, kPassesAtRest);
  passes.solve(settings, island, most, kSolved * built, balls, ledger);
  for (Contact* c : island) {
    c->share = shareAlone(*c, balls);
    c->isSolved = island.size() == 1;
  }
}

ResolvedCounts solveIslands(const Settings& settings, Balls& balls, ContactWorkspace& workspace,
                            const Ledger& ledger) {
  ResolvedCounts counts;
  for (std::size_t n = 0; n < workspace.islands.count(); ++n) {
    const auto island = workspace.islands.contacts(n);
    // One contact alone is solved by one pass, unless friction and resistance share its torque.
    const bool isCoupled = island.size() > 1 || settings.rollingResistance > 0;
    if (isCoupled && island[0]->isSmall && !anyImpact(island)) {
      if (solveDirectly(settings, island, balls, workspace.direct, ledger)) {
        counts.direct += static_cast<std::int64_t>(island.size());
        continue;
      }
      ++counts.unsolved;
    }
    solveByPasses(settings, island, balls, workspace.passes, ledger);
  }
  return counts;
}

// Overlap that the balls do not leave by themselves in the next substep.
template <class Partner>
void pushOut(const Arena& arena, double h, Balls& balls, Contact& c) {
  if (!c.acts) return;
  Partner::touch(arena, balls, c);
  const double left =
      c.isSolved ? 0 : kLeftOverlap * std::min(balls.radius[c.a], Partner::radius(balls, c));
  const double leaving = std::max(0.0, -closingSpeed<Partner>(balls.velocity.data(), c)) * h;
  // However fast it leaves, a centre does not stay outside.
  const double depth =
      std::max(-c.gap - leaving - left, -c.gap - kDeepest<Partner> * balls.radius[c.a]);
  if (depth <= 0) return;
  const Vec3 shift = (kShareOut<Partner> * depth * normalMass(c)) * c.normal;
  balls.position[c.a] -= c.inverseMassA * shift;
  Partner::shift(balls, c, shift);
}

/// Calls action.template operator()<Partner>(contact) for all contacts that touch or touched when
/// islands were found, of each island the arena's last.
template <class Action>
void forEach(const TouchingIslands& islands, Action action) {
  for (Contact* c : islands.contacts())
    withPartner(*c, [&]<class Partner>() { action.template operator()<Partner>(*c); });
}

}  // namespace

ResolvedCounts resolveContacts(const Settings& settings, const Arena& arena, double h,
                               const ContactLists& contacts, const Vec3* velocityBefore,
                               Balls& balls, ContactWorkspace& workspace,
                               const SubstepBooks* booking) {
  // The order of the impulses would decide what is booked as friction; only their sum is used.
  Books impulses;
  const Ledger ledger = booking ? Ledger{&impulses, arena.center} : Ledger{};
  const auto placement = [&] {
    return placementOf(ledger, *booking->field, booking->end, booking->touching, balls);
  };
  StageScope stage(workspace.clock, Stage::Prepare);
  for (Contact& c : contacts.balls) findTouch<BallPartner>(arena, h, velocityBefore, balls, c);
  for (Contact& c : contacts.arena) findTouch<ArenaPartner>(arena, h, velocityBefore, balls, c);
  stage.next(Stage::Islands);
  findSmallIslands(contacts, balls.size(), workspace.islands);
  stage.next(Stage::Prepare);
  forEach(workspace.islands, [&]<class Partner>(Contact& c) {
    prepare<Partner>(settings, arena, h, velocityBefore, balls, c);
  });
  forEach(workspace.islands,
          [&]<class Partner>(Contact& c) { warmStart<Partner>(balls, c, ledger); });
  stage.next(Stage::Solve);
  const ResolvedCounts counts = solveIslands(settings, balls, workspace, ledger);
  stage.next(Stage::Books);
  const double normals =
      booking ? workOfNormals(contacts.balls, balls) + workOfNormals(contacts.arena, balls) : 0;
  const Placement solved = booking ? placement() : Placement{};
  if (booking) {
    for (const Contact& c : contacts.balls) bookTurnedNormal(ledger, c, balls);
    for (const Contact& c : contacts.arena)
      bookArena(ledger, c, c.tangentImpulse - c.normalImpulse * c.normal, balls);
  }
  stage.next(Stage::Push);
  forEach(workspace.islands,
          [&]<class Partner>(Contact& c) { shiftByContactForce<Partner>(h, balls, c); });
  stage.next(Stage::Books);
  const Placement shifted = booking ? placement() : Placement{};
  stage.next(Stage::Push);
  forEach(workspace.islands,
          [&]<class Partner>(Contact& c) { pushOut<Partner>(arena, h, balls, c); });
  if (!booking) return counts;
  stage.next(Stage::Books);
  const Placement pushed = placement();
  const double both = impulses.contacts + impulses.friction + shifted.potential - solved.potential;
  impulses.contacts = normals;
  impulses.friction = settings.friction > 0 || settings.rollingResistance > 0 ? both - normals : 0;
  // Without friction, the rest is by how much the pull of the fields varies over the shifts.
  impulses.pushOut = pushed.potential - shifted.potential + both - normals - impulses.friction;
  impulses.shifts.angular += pushed.angular - solved.angular;
  *booking->books += impulses;
  return counts;
}

}  // namespace wells
