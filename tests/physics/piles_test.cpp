// Piles of which every force is known: the small islands that are solved directly, with the default
// settings of a world.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "scenes/exact_answers.h"
#include "scenes/piles.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr double kWeight = 9.81;  // N, of a ball of 1 kg

struct Force {
  double normal = 0;   // N
  double tangent = 0;  // N
};

/// A world, its engine, and the forces of contact that the engine remembers. Nothing sleeps, so
/// that what stands does so by its forces.
class Pile {
 public:
  explicit Pile(World start) : world(std::move(start)), start_(world.balls) {
    world.settings.sleepSpeed = 0;
  }

  void step() {
    simulation_->step(world);
    unsolved += simulation_->counts().unsolvedIslands;
  }

  /// By pair, of the last substep; only those that push.
  std::map<std::pair<std::uint32_t, std::uint32_t>, Force> forces() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Force> forces;
    const StepperMemory& memory = *simulation_->memory();
    for (const auto* list : {&memory.ballContacts, &memory.arenaContacts})
      for (const auto& c : *list)
        if (c.normalImpulse > 0)
          forces[{c.a, c.b}] = {c.normalImpulse / memory.substep,
                                length(c.tangentImpulse) / memory.substep};
    return forces;
  }

  double distance(std::size_t i, std::size_t j) const {
    return length(world.balls.position[i] - world.balls.position[j]);
  }
  double startDistance(std::size_t i, std::size_t j) const {
    return length(start_.position[i] - start_.position[j]);
  }
  /// m, the most by which a distance between two balls, or a height, differs from the start's.
  double deformation() const {
    double worst = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) {
      worst = std::max(worst, std::abs(world.balls.position[i].y() - start_.position[i].y()));
      for (std::size_t j = 0; j < i; ++j)
        worst = std::max(worst, std::abs(distance(i, j) - startDistance(i, j)));
    }
    return worst;
  }
  Vec3 moved(std::size_t i) const { return world.balls.position[i] - start_.position[i]; }

  World world;
  std::int64_t unsolved = 0;

 private:
  Balls start_;
  std::unique_ptr<Stepper> simulation_ = makeSimulation();
};

// The line from a lower centre to the top one makes an angle a with the vertical, sin a = s/sqrt(3)
// for a side s. Each lower ball: no torque, so the friction above it and the one below are of one
// size T; along the ground N sin a = T (1 + cos a); the top ball W = 3 (N cos a + T sin a). So T /
// N = tan(a/2), N = W/3, and 4 W/3 from the ground. For s = 1, tan(a/2) = sqrt(3) - sqrt(2) =
// 0.3178372 and T = 0.1059457 W.
TEST(TetrahedralPile, StandsWithFrictionOf32) {
  Pile pile(makeTetrahedralPile(0.32));
  const double sine = (1 + kPileGap) / std::sqrt(3.0);
  const double friction = kWeight / 3 * sine / (1 + std::sqrt(1 - sine * sine));
  double worstForce = 0;
  double worstDeformation = 0;
  for (int step = 0; step < 600; ++step) {
    pile.step();
    const auto forces = pile.forces();
    ASSERT_EQ(forces.size(), 6u) << step;
    for (std::uint32_t base = 0; base < 3; ++base) {
      const Force top = forces.at({base, 3});
      const Force ground = forces.at({base, kGround});
      for (const double error :
           {top.normal / (kWeight / 3) - 1, ground.normal / (4 * kWeight / 3) - 1,
            top.tangent / friction - 1, ground.tangent / friction - 1})
        worstForce = std::max(worstForce, std::abs(error));
    }
    worstDeformation = std::max(worstDeformation, pile.deformation());
  }
  EXPECT_NEAR(friction / kWeight, 0.1059457, 2e-7);
  EXPECT_LE(worstForce, 1e-9);
  EXPECT_LE(worstDeformation, 1e-12);
  EXPECT_LE(measure(pile.world).kineticEnergy, 1e-20);
  EXPECT_EQ(pile.unsolved, 0);
}

// Below sqrt(3) - sqrt(2) the top ball slips on the others, which roll out: with friction mu N
// above, the lower balls' outward acceleration 0.0760485 and the top's -0.0537744 m/s^2 at the
// start (mu = 0.30). From rest, 2 x / t^2 over a short time, in which the pile has hardly changed
// its shape.
TEST(TetrahedralPile, FallsWithFrictionOf30) {
  Pile pile(makeTetrahedralPile(0.30));
  for (int step = 1; step <= 6; ++step) {
    pile.step();
    const double half = pile.world.time() * pile.world.time() / 2;
    for (std::size_t base = 0; base < 3; ++base) {
      const Vec3 moved = pile.moved(base);
      EXPECT_NEAR(std::hypot(moved.x(), moved.z()) / half / 0.0760485, 1, 0.01) << step;
    }
    EXPECT_NEAR(pile.moved(3).y() / half / -0.0537744, 1, 0.01) << step;
  }
  EXPECT_EQ(pile.unsolved, 0);
}

// To where the equations of the falling pile end after 1 s (tests/scenes derives that): the error
// falls with the square of the step.
TEST(TetrahedralPile, FallsToWhereItMust) {
  const AccuracyCase& answer = findAccuracyCase("pile-slips");
  double before = 0;
  for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240}) {
    World world = makeTetrahedralPile(0.30);
    world.settings.dt = dt;
    Pile pile(world);
    while (pile.world.time() < answer.duration - dt / 2) pile.step();
    const double error = positionError(answer, pile.world);
    EXPECT_LE(error, 3e-7 * (60 * dt) * (60 * dt));
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.1);
    }
    before = error;
  }
}

TEST(Column, OfTenCarriesItsWeightAndStaysOnItsAxis) {
  Pile pile(makeColumn(10, 1));
  double worst = 0;
  for (int step = 0; step < 600; ++step) {
    pile.step();
    const auto forces = pile.forces();
    ASSERT_EQ(forces.size(), 10u) << step;
    for (std::uint32_t k = 0; k < 10; ++k) {
      const Force below = k == 0 ? forces.at({0, kGround}) : forces.at({k - 1, k});
      worst = std::max(worst, std::abs(below.normal / ((10 - k) * kWeight) - 1));
      ASSERT_EQ(below.tangent, 0);
      const BallState ball = pile.world.balls.state(k);
      for (const int axis : {0, 2}) {
        ASSERT_EQ(ball.position[axis], 0) << step << " " << k;
        ASSERT_EQ(ball.velocity[axis], 0) << step << " " << k;
      }
      ASSERT_EQ(ball.spin, Vec3(0, 0, 0));
    }
  }
  EXPECT_LE(worst, 1e-9);
  EXPECT_LE(pile.deformation(), 1e-12);
}

// Dropped with gaps between them, three balls in a column come to rest on each other and on the
// ground: impacts, bounces that are too short for a substep, rest.
TEST(Column, ThatIsDroppedComesToRest) {
  for (const double elasticity : {0.3, 0.8}) {
    World world = makeColumn(3, 1);
    world.settings.elasticity = elasticity;
    for (std::size_t k = 0; k < 3; ++k)
      world.balls.position[k].y() += 0.1 * (static_cast<double>(k) + 1);
    Pile pile(world);
    for (int step = 0; step < 600; ++step) pile.step();
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(pile.world.balls.position[k].y(), 0.5 + static_cast<double>(k), 1e-12);
    EXPECT_LE(measure(pile.world).kineticEnergy, 1e-24);
    EXPECT_EQ(pile.unsolved, 0);
  }
}

TEST(HeavyOnLight, Stands) {
  Pile pile(makeHeavyOnLight(0, 0));
  double deepest = 0;
  double worst = 0;
  for (int step = 0; step < 600; ++step) {
    pile.step();
    deepest = std::max(deepest, measure(pile.world).worstOverlap());
    const auto forces = pile.forces();
    ASSERT_EQ(forces.size(), 2u) << step;
    worst = std::max({worst, std::abs(forces.at({0, 1}).normal / (1e6 * kWeight) - 1),
                      std::abs(forces.at({0, kGround}).normal / ((1e6 + 1) * kWeight) - 1)});
  }
  EXPECT_LE(deepest, 1e-9 * 0.5);
  EXPECT_LE(worst, 1e-8);  // rounding, times the ratio of the masses
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE(std::abs(pile.moved(i).y()), 1e-9);
    EXPECT_EQ(pile.moved(i).x(), 0);
    EXPECT_EQ(pile.moved(i).z(), 0);
  }
}

// A ball of mass M on one of mass m of the same radius r, on the ground, moved aside by a small
// x = x_M - x_m; d = 2 r, and N the force on M along the line of centres, M g to first order.
// Without friction: M x_M'' = N x/d, m x_m'' = -N x/d, so x'' = (1 + M/m) (g/d) x.
// With friction both contacts roll. For m << M the light ball is a roller without inertia: the
// force (F, -N) on its top, at (r x/d, 2 r) from its foot, has no torque about the foot, so the
// heavy one feels (N x/(2 d), N): M x_M'' = M g x/(2 d), and 2/5 M r^2 w' = -r M g x/(2 d). Rolling
// on the top, which moves at 2 x_m': x_M' + r w = 2 x_m'. Together x'' = (1/2 + 3/8) (g/d) x = 7/8
// (g/d) x. From rest, x = x_0 cosh(k t).
double ratioToCosh(const Pile& pile, double x0, double rate) {
  const double x = pile.world.balls.position[1].x() - pile.world.balls.position[0].x();
  return x / (x0 * std::cosh(rate * pile.world.time()));
}

TEST(HeavyOnLight, NudgedRollsDownAtTheAnalyticRate) {
  Pile pile(makeNudgedHeavyOnLight(0, 0));
  double worst = 0;
  for (int step = 0; step < 180; ++step) {  // until x = 3 mm
    pile.step();
    worst = std::max(worst, std::abs(ratioToCosh(pile, kNudge, std::sqrt(7.0 / 8 * 9.81)) - 1));
  }
  EXPECT_LE(worst, 2e-4);
}

// The error falls with the square of the step.
TEST(EqualBalls, OnASmoothGroundNudgedFallAtTheAnalyticRate) {
  double before = 0;
  for (const double dt : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
    World world = makeNudgedHeavyOnLight(0, 0);
    world.settings.friction = 0;
    world.settings.dt = dt;
    world.balls.mass[1] = 1;
    Pile pile(world);
    while (pile.world.time() < 1.75 - dt / 2) pile.step();  // until x = 1 mm
    const double error = std::abs(ratioToCosh(pile, kNudge, std::sqrt(2 * 9.81)) - 1);
    EXPECT_LE(error, 2e-4 * (60 * dt) * (60 * dt));
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.4);
    }
    before = error;
  }
}

}  // namespace
}  // namespace wells
