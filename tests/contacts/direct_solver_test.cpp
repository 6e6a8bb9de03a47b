#include "contacts/direct_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contacts/partners.h"
#include "math/random.h"

namespace wells {
namespace {

/// Contacts and the balls they hold; every contact touches.
struct Island {
  double friction = 0;
  double rollingResistance = 0;  // m
  Balls balls;
  std::vector<Contact> contacts;

  std::vector<Contact*> pointers() {
    std::vector<Contact*> list;
    for (Contact& c : contacts) list.push_back(&c);
    return list;
  }

  void give(std::size_t i, const DirectSolver::Impulse& impulse) {
    const Contact& c = contacts[i];
    withPartner(c, [&]<class Partner>() {
      applyImpulse<Partner>(balls, c, -impulse.normal * c.normal);
      applyTangentImpulse<Partner>(balls, c, impulse.tangent);
      applyTorqueImpulse<Partner>(balls, c, impulse.rolling);
    });
  }

  Vec3 rolling(std::size_t i) const {
    Vec3 rolling;
    withPartner(contacts[i],
                [&]<class Partner>() { rolling = rollingVelocity<Partner>(balls, contacts[i]); });
    return rolling;
  }

  /// m, the radius of a ball that a torque at that contact turns as it does both.
  double rollingArm(std::size_t i) const {
    double inverse = 0;
    withPartner(contacts[i], [&]<class Partner>() {
      inverse = inverseTurningInertia<Partner>(balls, contacts[i]);
    });
    return std::sqrt(kSpinFactor / (normalMass(contacts[i]) * inverse));
  }

  Vec3 slip(std::size_t i) const {
    Vec3 slip;
    withPartner(contacts[i],
                [&]<class Partner>() { slip = slipVelocity<Partner>(balls, contacts[i]); });
    return slip;
  }

  double parting(std::size_t i) const {
    return -closingSpeed(balls, contacts[i]) - contacts[i].bounceSpeed;
  }
};

double decades(Random& random, double from, double to) {
  return std::exp(random.uniform(std::log(from), std::log(to)));
}

/// Any graph of contacts between balls, ground and wall; it does not have to fit in space.
Island randomIsland(Random& random, std::size_t contactCount, double mostMassRatio) {
  Island island;
  island.friction = random.uniform() < 0.2 ? 0 : random.uniform(0, 1);
  const auto ballCount = 2 + contactCount / 3 + random.below(contactCount);
  for (std::uint64_t i = 0; i < ballCount; ++i)
    island.balls.add({.velocity = random.direction() * random.uniform(),
                      .spin = random.direction() * random.uniform()},
                     decades(random, 0.1, 10), decades(random, 1, mostMassRatio));
  Balls moving = island.balls;
  for (Vec3& velocity : moving.velocity) velocity = random.direction() * random.uniform();
  while (island.contacts.size() < contactCount) {
    Contact c;
    c.a = static_cast<std::uint32_t>(random.below(ballCount));
    c.b = static_cast<std::uint32_t>(random.below(ballCount));
    if (c.a >= c.b) c.b = c.a == c.b ? kGround : kWall;
    if (std::ranges::any_of(island.contacts,
                            [&](const Contact& other) { return other.a == c.a && other.b == c.b; }))
      continue;
    const Vec3 direction = random.direction();
    const Vec3 outward = Vec3(direction.x(), 0, direction.z());
    c.normal = isBall(c.b)      ? direction
               : c.b == kGround ? Vec3(0, -1, 0)
                                : Vec3(outward / length(outward));
    c.inverseMassA = 1 / island.balls.mass[c.a];
    c.inverseMassB = isBall(c.b) ? 1 / island.balls.mass[c.b] : 0;
    // No faster than they part in one of all possible motions, so that a solution exists.
    const double possible = -closingSpeed(moving, c);
    c.bounceSpeed = random.uniform() < 0.5 ? std::min(0.0, possible) : possible;
    island.contacts.push_back(c);
  }
  return island;
}

/// How far velocities and impulses are from the laws of contact, relative to the largest impulse
/// per mass. Knows nothing of how they were found.
double violation(const Island& island, const std::vector<DirectSolver::Impulse>& given) {
  double worst = 0;
  double largest = 1e-3;  // m/s
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Contact& c = island.contacts[i];
    const double mass = normalMass(c);
    const double normal = given[i].normal / mass;
    const Vec3 tangent = given[i].tangent / mass;
    const Vec3 slip = island.slip(i);
    const double parting = island.parting(i);
    largest = std::max(largest, normal);
    const double excess = length(tangent) - island.friction * normal;
    const double product = parting > normal ? normal : parting;  // one of the two is 0
    worst = std::max({worst, -normal, -parting, product, excess, std::abs(dot(tangent, c.normal))});
    // Opposite to the slip, and at the cone's edge, or no slip: of the two, the smaller counts.
    const double speed = length(slip);
    if (speed > 0) {
      const Vec3 expected = -island.friction * normal / speed * slip;
      worst = std::max(worst, std::min(length(tangent - expected), speed));
    }
    // The same of the torque and the rolling, in m/s at the radius.
    const double arm = island.rollingArm(i);
    const Vec3 torque = given[i].rolling / (mass * arm);
    const double most = island.rollingResistance / arm * normal;
    const Vec3 rolling = arm * island.rolling(i);
    worst = std::max({worst, length(torque) - most, std::abs(dot(torque, c.normal))});
    const double turning = length(rolling);
    if (turning > 0)
      worst = std::max(worst, std::min(length(torque + most / turning * rolling), turning));
  }
  return worst / largest;
}

std::vector<DirectSolver::Impulse> solveAndGive(Island& island, DirectSolver& solver,
                                                bool& isSolved) {
  const auto pointers = island.pointers();
  isSolved = solver.solve(island.friction, pointers, island.balls, island.rollingResistance);
  std::vector<DirectSolver::Impulse> given(solver.impulses().begin(), solver.impulses().end());
  for (std::size_t i = 0; i < given.size(); ++i) island.give(i, given[i]);
  return given;
}

// Signorini's conditions and Coulomb's cone, held directly, on islands of 1 to 6 contacts.
TEST(DirectSolver, ObeysTheLawsOfContact) {
  Random random(1);
  DirectSolver solver;
  int unsolved = 0;
  constexpr int kTrials = 20000;
  for (int trial = 0; trial < kTrials; ++trial) {
    Island island = randomIsland(random, 1 + static_cast<std::size_t>(trial % 6), 10);
    bool isSolved = false;
    const auto given = solveAndGive(island, solver, isSolved);
    if (!isSolved) {
      ++unsolved;
      continue;
    }
    ASSERT_LE(violation(island, given), 1e-11) << trial;
  }
  EXPECT_LE(unsolved, kTrials / 1000);
}

// With rolling resistance there is a second cone of each contact.
TEST(DirectSolver, ObeysTheLawsOfRollingResistance) {
  Random random(4);
  DirectSolver solver;
  int unsolved = 0;
  constexpr int kTrials = 10000;
  for (int trial = 0; trial < kTrials; ++trial) {
    Island island = randomIsland(random, 1 + static_cast<std::size_t>(trial % 6), 10);
    island.rollingResistance = decades(random, 1e-3, 10);
    bool isSolved = false;
    const auto given = solveAndGive(island, solver, isSolved);
    if (!isSolved) {
      ++unsolved;
      continue;
    }
    ASSERT_LE(violation(island, given), 1e-10) << trial;
  }
  EXPECT_LE(unsolved, kTrials / 500);
}

TEST(DirectSolver, ObeysThemWithLargeMassRatiosAndManyContacts) {
  Random random(2);
  DirectSolver solver;
  for (const double ratio : {1e3, 1e6})
    for (const std::size_t contacts : {6, 12, 24}) {
      std::size_t unsolved = 0;
      const std::size_t trials = 3000 / contacts;
      for (std::size_t trial = 0; trial < trials; ++trial) {
        Island island = randomIsland(random, contacts, ratio);
        bool isSolved = false;
        const auto given = solveAndGive(island, solver, isSolved);
        if (isSolved)
          EXPECT_LE(violation(island, given), 1e-10) << ratio << " " << contacts << " " << trial;
        else
          ++unsolved;
      }
      EXPECT_LE(unsolved, 1 + trials / 10) << ratio << " " << contacts;
    }
}

/// One impulse after the other, a great many times over; `sweeps` left when nothing moves any more.
std::vector<DirectSolver::Impulse> gaussSeidel(Island& island, int& sweeps) {
  std::vector<DirectSolver::Impulse> total(island.contacts.size());
  double largest = 1;
  for (; sweeps > 0 && largest > 1e-15; --sweeps) {
    largest = 0;
    for (std::size_t i = 0; i < total.size(); ++i) {
      const Contact& c = island.contacts[i];
      const double normal = std::max(0.0, total[i].normal - normalMass(c) * island.parting(i));
      island.give(i, {normal - total[i].normal, Vec3::Zero()});
      Vec3 tangent = total[i].tangent - tangentMass(c) * island.slip(i);
      const double limit = island.friction * normal;
      if (length(tangent) > limit) tangent *= limit / length(tangent);
      island.give(i, {0, tangent - total[i].tangent});
      largest = std::max({largest, std::abs(normal - total[i].normal) * c.inverseMassA,
                          length(tangent - total[i].tangent) * c.inverseMassA});
      total[i] = {normal, tangent};
    }
  }
  return total;
}

// Where brute force ends, both leave the balls with the same velocities. (Friction allows islands
// with several solutions; they are rare.)
TEST(DirectSolver, AgreesWithBruteForce) {
  Random random(3);
  DirectSolver solver;
  int compared = 0;
  int different = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Island island = randomIsland(random, 1 + random.below(6), 10);
    Island twin = island;
    bool isSolved = false;
    solveAndGive(island, solver, isSolved);
    int sweeps = 20000;
    gaussSeidel(twin, sweeps);
    if (!isSolved || sweeps == 0) continue;
    ++compared;
    double difference = 0;
    for (std::size_t i = 0; i < island.balls.size(); ++i)
      difference = std::max(difference, length(island.balls.velocity[i] - twin.balls.velocity[i]));
    if (difference > 1e-9) ++different;
  }
  EXPECT_GE(compared, 1900);
  EXPECT_LE(different, 10);
}

}  // namespace
}  // namespace wells
