// Rolling resistance: a ball on ground or wall that it slows down, stops and holds, against closed
// forms and independent paths.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "scenes/unit_balls.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"
#include "support/order.h"
#include "support/step_errors.h"
#include "world/measures.h"

namespace wells {
namespace {

constexpr double kG = 9.81;  // m/s^2
constexpr double kR = 0.5;   // m
const Vec3 kStart(1, kR, -2);
const Vec3 kAhead(0.6, 0, 0.8);

/// On the ground, moving ahead at `speed` and spinning as if it rolled at `rolling` (m/s).
World onGround(double friction, double resistance, double speed, double rolling) {
  World world;
  world.settings.friction = friction;
  world.settings.rollingResistance = resistance;
  addUnitBall(world, kStart, speed * kAhead, rolling / kR * cross(Vec3(0, 1, 0), kAhead));
  return world;
}

/// m, how far it has come.
double way(const World& world) {
  return dot(world.balls.position[0] - kStart, kAhead);
}

void expectBitsKept(World& world, double duration) {
  const BallState rest = world.balls.state(0);
  EXPECT_EQ(rest.velocity, Vec3(0, 0, 0));
  const RunCounts counts = runFor(world, duration);
  EXPECT_EQ(counts.substepBalls, 0);
  EXPECT_EQ(world.balls.position[0], rest.position);
  EXPECT_EQ(world.balls.velocity[0], rest.velocity);
  EXPECT_EQ(world.balls.spin[0], rest.spin);
}

// Newton: v' = -f. Euler: 2/5 r w' = f - b/r g. Rolling, v = r w: f = 5/7 b/r g.
TEST(RollingResistance, StopsARollingBall) {
  for (const double dt : {1.0 / 10, 1.0 / 60, 1.0 / 480}) {
    World world = onGround(0.3, 0.02, 1.5, 1.5);
    world.settings.dt = dt;
    const double braking = 5.0 / 7 * 0.02 / kR * kG;
    runFor(world, 5);
    EXPECT_NEAR(length(world.balls.velocity[0]), 1.5 - 5 * braking, 1e-12) << dt;
    EXPECT_NEAR(way(world), 1.5 * 5 - braking * 25 / 2, 1e-12) << dt;
    runFor(world, 1);  // it stops after v / braking = 5.35 s
    EXPECT_NEAR(way(world), 1.5 * 1.5 / (2 * braking), 1e-12) << dt;
    EXPECT_EQ(world.balls.spin[0], Vec3(0, 0, 0));
    expectBitsKept(world, 10);
  }
}

TEST(RollingResistance, StopsABallThatSlid) {
  for (const double rate : {6, 60, 960}) {
    World world = makeScene(findScene("rolling-stops"));
    world.settings.dt = 1 / rate;
    runFor(world, 3);
    EXPECT_LE(positionError(findAccuracyCase("rolling-stops"), world), 1e-11) << rate;
    expectBitsKept(world, 2);
  }
}

// The torque on the ball is about the normal of no contact.
TEST(RollingResistance, LeavesTheSpinAboutTheNormal) {
  World world = onGround(0.3, 0.1, 1, 1);
  world.balls.spin[0].y() = 7;
  runFor(world, 2);
  EXPECT_EQ(world.balls.velocity[0], Vec3(0, 0, 0));
  EXPECT_LE(length(world.balls.spin[0] - Vec3(0, 7, 0)), 1e-14);
  expectBitsKept(world, 1);
}

// Friction of at most mu g turns it with mu g r against b g: not at all where b >= mu r. It slides
// until it rests.
TEST(RollingResistance, KeepsASlidingBallFromTurning) {
  for (const double resistance : {0.15, 0.16, 3.0}) {
    World world = onGround(0.3, resistance, 3, 0);
    runFor(world, 0.5);
    EXPECT_NEAR(length(world.balls.velocity[0]), 3 - 0.3 * kG * 0.5, 1e-12);
    EXPECT_EQ(world.balls.spin[0], Vec3(0, 0, 0));
    runFor(world, 1);
    EXPECT_NEAR(way(world), 9 / (2 * 0.3 * kG), 1e-11);
    expectBitsKept(world, 1);
  }
}

// Rolling takes the friction 5/7 b/r g: more than mu g where b > 7/5 mu r = 0.21 m. The ball then
// slides on, braked by mu g from its first moment to its last, its spin by 5/2 (b/r - mu) g.
TEST(RollingResistance, MakesARollingBallSlide) {
  World world = onGround(0.3, 0.25, 3, 3);
  runFor(world, 0.25);
  EXPECT_NEAR(length(world.balls.velocity[0]), 3 - 0.3 * kG * 0.25, 1e-12);
  EXPECT_NEAR(kR * length(world.balls.spin[0]), 3 - 2.5 * 0.2 * kG * 0.25, 1e-12);
  runFor(world, 0.5);
  EXPECT_LE(length(world.balls.spin[0]), 1e-14);  // none since 0.61 s
  EXPECT_NEAR(length(world.balls.velocity[0]), 3 - 0.3 * kG * 0.75, 1e-12);
  runFor(world, 1);
  EXPECT_NEAR(way(world), 9 / (2 * 0.3 * kG), 1e-11);
  expectBitsKept(world, 1);
  // At 0.20 m it rolls.
  world = onGround(0.3, 0.2, 3, 3);
  runFor(world, 0.5);
  EXPECT_NEAR(length(world.balls.velocity[0]), 3 - 5.0 / 7 * 0.4 * kG * 0.5, 1e-12);
  EXPECT_NEAR(kR * length(world.balls.spin[0]), length(world.balls.velocity[0]), 1e-12);
}

// On a frictionless ground nothing but the torque turns it: 5/2 b/r g less r w in a second.
TEST(RollingResistance, EndsASpinWithoutFriction) {
  World world = onGround(0, 0.02, 1, 3);
  world.balls.spin[0].y() = 2;
  runFor(world, 2);
  EXPECT_NEAR(kR * length(world.balls.spin[0] - Vec3(0, 2, 0)), 3 - 2.5 * 0.04 * kG * 2, 1e-12);
  runFor(world, 2);
  EXPECT_LE(length(world.balls.spin[0] - Vec3(0, 2, 0)), 1e-14);
  EXPECT_NEAR(way(world), 4, 1e-12);
}

// About the contact point a pull F turns it by F r against b N: b/r = 0.1 is the steepest slope.
TEST(RollingResistance, HoldsABallOnASlope) {
  for (const double slope : {0.0, 0.05, 0.0999, 0.1001, 0.2}) {
    World world = onGround(0.3, 0.05, 0, 0);
    world.settings.gravity = Vec3(0, -kG, 0) + slope * kG * kAhead;
    if (slope < 0.1) {
      expectBitsKept(world, 2);
      EXPECT_EQ(way(world), 0);
    } else {
      runFor(world, 2);
      EXPECT_NEAR(way(world), 5.0 / 7 * (slope - 0.1) * kG * 2, 1e-12) << slope;
    }
  }
}

// Up the slope braked by the pull and the resistance, down again by their difference.
TEST(RollingResistance, TurnsWithABallThatComesBack) {
  World world = onGround(0.3, 0.05, -2, -2);
  world.settings.gravity = Vec3(0, -kG, 0) + 0.3 * kG * kAhead;
  const double up = 5.0 / 7 * (0.3 + 0.1) * kG, down = 5.0 / 7 * (0.3 - 0.1) * kG;
  const double left = 2 - 2 / up;  // s
  runFor(world, 2);
  EXPECT_NEAR(way(world), -4 / (2 * up) + down * left * left / 2, 1e-12);
  EXPECT_NEAR(dot(world.balls.velocity[0], kAhead), down * left, 1e-12);
}

// N = v^2 / rho: v' = -5/7 b/r v^2 / rho.
TEST(RollingResistance, SlowsDownRoundTheWall) {
  World world = freeWorld();
  world.arena.radius = 10;
  world.settings.friction = 0.3;
  world.settings.rollingResistance = 0.05;
  addUnitBall(world, {9.5, 1, 0}, {0, 0, -5}, {0, -10, 0});
  runFor(world, 20);
  const double braking = 5.0 / 7 * 0.1 / 9.5;  // 1/m
  const double angle = std::log(1 + braking * 5 * 20) / braking / 9.5;
  EXPECT_LE(
      length(world.balls.position[0] - Vec3(9.5 * std::cos(angle), 1, -9.5 * std::sin(angle))),
      1e-8);
  EXPECT_NEAR(length(world.balls.velocity[0]), 5 / (1 + braking * 5 * 20), 1e-9);
}

// N = v^2 / rho, and friction cannot make it turn: v' = -mu v^2 / rho without end.
TEST(RollingResistance, KeepsABallAtTheWallFromTurning) {
  World world = freeWorld();
  world.arena.radius = 10;
  world.settings.friction = 0.3;
  world.settings.rollingResistance = 0.2;
  addUnitBall(world, {9.5, 1, 0}, {0, 0, -5});
  runFor(world, 20);
  const double angle = std::log(1 + 0.3 / 9.5 * 5 * 20) / 0.3;
  EXPECT_LE(
      length(world.balls.position[0] - Vec3(9.5 * std::cos(angle), 1, -9.5 * std::sin(angle))),
      1e-8);
  EXPECT_EQ(world.balls.spin[0], Vec3(0, 0, 0));
}

// A well on the axis, half a metre above it, presses it to the wall and pulls by 0.5 / 9.5 of that:
// less than b/r = 0.06.
TEST(RollingResistance, HoldsABallOnTheWall) {
  for (const double degrees : {0, 17, 133, 260}) {
    World world = freeWorld();
    world.arena = {.center = {3, -1, 2}, .radius = 10};
    world.settings.friction = 0.3;
    world.settings.rollingResistance = 0.03;
    world.tracks = {{.keyframes = {{0, {3, 5.5, 2}, -400}}, .softening = 2}};
    const double angle = degrees * std::numbers::pi / 180;
    addUnitBall(world, {3 + 9.5 * std::cos(angle), 5, 2 + 9.5 * std::sin(angle)});
    runFor(world, 1.0 / 60);
    expectBitsKept(world, 10);
  }
}

// The case of the catalogue: it rolls to and fro, and is held where the well no longer moves it.
TEST(RollingResistance, HoldsABallUnderAWell) {
  std::vector<std::pair<double, double>> errors;
  for (int n = 30; n <= 240; n *= 2) {
    World world = makeScene(findScene("stuck-under-a-well"));
    world.settings.dt = 1.0 / n;
    runFor(world, 10);
    errors.emplace_back(1.0 / n, positionError(findAccuracyCase("stuck-under-a-well"), world));
    expectBitsKept(world, 2);
  }
  EXPECT_LE(errors[1].second, 1e-10);
  EXPECT_GE(fittedOrder(errors), 3.8);
}

// A well that moves away draws the ball on from when its pull exceeds b/r g. From there on an
// independent integration of x'' = 5/7 (pull - b/r g).
TEST(RollingResistance, LetsGoWhenAWellPullsTooHard) {
  using oracle::Real;
  const auto pull = [](Real x, Real t) {
    const Real d = 3 * t - x;
    return 8 * d / std::pow(d * d + 4, 1.5L);
  };
  const Real hold = 0.02L / 0.5L * 9.81L;
  Real low = 0, high = 0.4L;
  for (int i = 0; i < 100; ++i) {
    const Real t = (low + high) / 2;
    (pull(0, t) > hold ? high : low) = t;
  }
  Real t = low, x = 0, v = 0;
  const Real until = 0.8L;
  const int steps = 20000;
  const Real h = (until - t) / steps;
  for (int i = 0; i < steps; ++i, t += h) {
    const auto a = [&](Real place, Real time) { return 5.0L / 7 * (pull(place, time) - hold); };
    const Real a1 = a(x, t), a2 = a(x + h / 2 * v, t + h / 2),
               a3 = a(x + h / 2 * (v + h / 2 * a1), t + h / 2),
               a4 = a(x + h * (v + h / 2 * a2), t + h);
    x += h * (v + h / 6 * (a1 + a2 + a3));
    v += h / 6 * (a1 + 2 * (a2 + a3) + a4);
  }
  const auto worldOf = [](double dt) {
    World world = onGround(0.3, 0.02, 0, 0);
    world.settings.dt = dt;
    world.balls.position[0] = {0, kR, 0};
    world.tracks = {
        {.keyframes = {{0, {0, kR, 0}, 8}, {std::llround(1 / dt), {3, kR, 0}, 8}}, .softening = 2}};
    return world;
  };
  const auto errors = stepErrors(worldOf, 0.8, {static_cast<double>(x), kR, 0});
  EXPECT_LE(errors.front().second, 1e-7);
  EXPECT_GE(fittedOrder(errors), 3.8);
}

/// A ball on another one on the ground; the line of their centres leans by asin(lean / r), so that
/// the upper one's weight acts `lean` (m) beside the contact.
World leaningColumn(double lean) {
  World world;
  world.settings.elasticity = 0;
  world.settings.rollingResistance = 0.05;
  const double up = std::sqrt(kR * kR - lean * lean);
  addUnitBall(world, {0, kR, 0});
  addUnitBall(world, {2 * lean, kR + 2 * up, 0});
  return world;
}

// Forces are vertical, as nothing pushes sideways. About its centre the upper ball's W acts at the
// arm `lean`, against up to b N, N = W cos: it stands while r tan <= b. The lower one has twice the
// torque, of both contacts, and twice the weight to press it.
TEST(RollingResistance, HoldsABallOnAnother) {
  // r tan = 0.049 and 0.051
  for (const auto& [arm, stands] : {std::pair{0.049, true}, {0.051, false}}) {
    World world = leaningColumn(arm / std::sqrt(1 + arm * arm / (kR * kR)));
    const Vec3 lower = world.balls.position[0], upper = world.balls.position[1];
    runFor(world, stands ? 10 : 3);
    const double moved =
        length(world.balls.position[0] - lower) + length(world.balls.position[1] - upper);
    if (stands)
      EXPECT_LE(moved, 1e-9);
    else
      EXPECT_GE(moved, 0.1);
  }
}

// By substeps, where the contact's position within a substep is not resolved: second order.
TEST(RollingResistance, StopsABallInSubsteps) {
  World world = onGround(0.3, 0.02, 1.5, 1.5);
  world.settings.contactMethod = ContactMethod::Substep;
  const double braking = 5.0 / 7 * 0.02 / kR * kG;
  runFor(world, 6);
  EXPECT_NEAR(way(world), 1.5 * 1.5 / (2 * braking), 1e-3);
  const Vec3 rest = world.balls.position[0];
  runFor(world, 10);
  EXPECT_LE(length(world.balls.position[0] - rest), 1e-12);
  EXPECT_LE(length(world.balls.velocity[0]), 1e-12);
}

// Substeps start from the torque of the one before; not from one that is no more.
TEST(RollingResistance, CanBeSwitchedOff) {
  World world = onGround(0.3, 0.05, 0, 0);
  world.settings.contactMethod = ContactMethod::Substep;
  world.settings.gravity = Vec3(0, -kG, 0) + 0.05 * kG * kAhead;
  const auto simulation = makeSimulation();
  for (int i = 0; i < 60; ++i) simulation->step(world);
  EXPECT_LE(std::abs(way(world)), 1e-12);
  world.settings.rollingResistance = 0;
  for (int i = 0; i < 60; ++i) simulation->step(world);
  EXPECT_NEAR(way(world), 5.0 / 7 * 0.05 * kG / 2, 1e-3);
}

// As the resistance goes to nothing, so does what it changes.
TEST(RollingResistance, OfNextToNothingChangesNothing) {
  for (const char* name : {"rolling-well", "backspin", "wall-rolling", "wall-slide-to-roll",
                           "zeno-rest", "pile-stands", "column"}) {
    World without = makeScene(findScene(name));
    World with = without;
    with.settings.rollingResistance = 1e-15;
    runFor(without, 1);
    runFor(with, 1);
    for (std::size_t i = 0; i < with.balls.size(); ++i)
      EXPECT_LE(length(with.balls.position[i] - without.balls.position[i]), 1e-11) << name;
  }
}

struct BookedRun {
  Books books;
  double gained = 0;           // J
  double largestRise = 0;      // J, of contacts and friction together in one step
  Vec3 turned = Vec3::Zero();  // kg m^2/s
};

BookedRun book(World& world, double duration) {
  const auto simulation = makeSimulation();
  simulation->openBooks();
  const Measures start = measure(world);
  BookedRun run;
  for (std::int64_t i = 0; i < std::llround(duration / world.settings.dt); ++i) {
    const Books before = *simulation->books();
    simulation->step(world);
    run.books = *simulation->books();
    run.largestRise = std::max(run.largestRise, run.books.contacts + run.books.friction -
                                                    before.contacts - before.friction);
  }
  const Measures end = measure(world);
  run.gained = end.energy() - start.energy();
  run.turned = end.angularMomentum - start.angularMomentum;
  return run;
}

// All the energy of 7/10 m v^2 goes into friction, and the ground's torque is booked.
TEST(RollingResistance, IsBooked) {
  for (const ContactMethod method : {ContactMethod::Exact, ContactMethod::Substep}) {
    World world = onGround(0.3, 0.02, 1.5, 1.5);
    world.settings.contactMethod = method;
    const BookedRun run = book(world, 6);
    EXPECT_NEAR(run.books.friction, -0.7 * 1.5 * 1.5, 1e-12);
    EXPECT_NEAR(run.books.energy(), run.gained, 1e-12);
    EXPECT_LE(length(run.books.angularImpulse() - run.turned), 1e-10);
    EXPECT_LE(run.largestRise, 1e-13);
  }
}

// Heaps under wells, also with arms that no ball can roll against.
TEST(RollingResistance, AddsNoEnergyToAHeap) {
  for (const double resistance : {1e-300, 0.02, 0.15, 1e6})
    for (const std::size_t balls : {10, 60}) {
      World world = makeScene(findScene("T1"), balls);
      world.settings.rollingResistance = resistance;
      const BookedRun run = book(world, 3);
      EXPECT_LT(run.books.friction, 0) << resistance;
      EXPECT_LE(run.largestRise, 1e-9) << resistance;
      EXPECT_NEAR(run.books.energy(), run.gained, 1e-9 * std::abs(run.gained)) << resistance;
      EXPECT_LE(length(run.books.angularImpulse() - run.turned), 1e-7) << resistance;
    }
}

}  // namespace
}  // namespace wells
