// The books against closed forms, and against the sums that measures.h computes from the state: all
// that the balls gained and lost is booked somewhere.
#include "state/books.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/catalogue.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

struct BookedRun {
  World world;
  Books books;
  Measures start;
  Measures end;
};

BookedRun run(World world, int steps) {
  const auto simulation = makeSimulation();
  EXPECT_TRUE(simulation->openBooks());
  BookedRun result;
  result.start = measure(world);
  for (int i = 0; i < steps; ++i) simulation->step(world);
  result.end = measure(world);
  result.books = *simulation->books();
  result.world = std::move(world);
  return result;
}

/// Of the sums themselves, whose terms are rounded as often as there are balls and steps.
void expectClosed(const BookedRun& r, double tolerance) {
  double momentum = 0;  // sum of m |v|
  double angular = 0;
  const Balls& balls = r.world.balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    momentum += balls.mass[i] * length(balls.velocity[i]);
    angular += balls.mass[i] * length(balls.velocity[i]) * r.world.arena.radius;
  }
  const double energy = std::abs(r.start.energy()) + std::abs(r.end.energy()) + r.end.kineticEnergy;
  EXPECT_NEAR(r.books.energy(), r.end.energy() - r.start.energy(), tolerance * energy);
  EXPECT_LE(length(r.books.impulse() - (r.end.momentum - r.start.momentum)),
            tolerance * (1 + momentum + length(r.books.fields.linear)));
  EXPECT_LE(
      length(r.books.angularImpulse() - (r.end.angularMomentum - r.start.angularMomentum)),
      tolerance * (1 + angular + length(r.books.fields.angular) + length(r.books.ground.angular)));
}

World oneBall(double elasticity, double friction, const BallState& state) {
  World world;
  world.settings.elasticity = elasticity;
  world.settings.friction = friction;
  world.balls.add(state, 0.5, 2);
  return world;
}

// Of the kinetic energy 1/2 m v^2 the sliding ball keeps 5/7 when it rolls: 1/7 m v^2 goes.
TEST(Books, SlidingLosesTwoSeventhsToFriction) {
  const BookedRun r = run(oneBall(0.8, 0.3, {{0, 0.5, 0}, {5, 0, 0}}), 120);
  EXPECT_NEAR(r.books.friction, -2 * 25.0 / 7, 1e-12);
  EXPECT_EQ(r.books.contacts, 0);
  // m g t up, and m (v0 - 5/7 v0) against the motion.
  EXPECT_NEAR(r.books.ground.linear.y(), 2 * 9.81 * 2, 1e-11);
  EXPECT_NEAR(r.books.ground.linear.x(), -2 * 5 * 2.0 / 7, 1e-12);
  EXPECT_NEAR(r.books.fields.linear.y(), -2 * 9.81 * 2, 1e-11);
  expectClosed(r, 1e-13);
}

// The same round the wall, which turns the ball; the impulses of both are the wall's.
TEST(Books, SlidingAlongTheWallLosesTwoSeventhsToFriction) {
  const BookedRun r = run(makeScene(findScene("wall-slide-to-roll")), 300);
  EXPECT_NEAR(r.books.friction, -25.0 / 7, 1e-10);
  EXPECT_EQ(r.books.contacts, 0);
  EXPECT_EQ(length(r.books.ground.linear), 0);
  EXPECT_GT(length(r.books.wall.linear), 1);
  expectClosed(r, 1e-12);
}

// What friction holds up does no work.
TEST(Books, RollingRoundTheWallLosesNothing) {
  const BookedRun r = run(makeScene(findScene("wall-rolling")), 600);
  EXPECT_NEAR(r.books.friction, 0, 1e-10);
  EXPECT_NEAR(r.books.flight, 0, 1e-6 * r.end.energy());
  EXPECT_EQ(r.books.contacts, 0);
  expectClosed(r, 1e-12);
}

// In the corner: 7/10 m v^2 when it rolls on the ground, 9/10 m (7/9 v)^2 when it rolls on both.
// Ground and wall together bear the weight.
TEST(Books, SlidingInTheCornerLosesTwoNinthsToFriction) {
  const BookedRun r = run(makeScene(findScene("corner-slide-to-roll")), 600);
  EXPECT_NEAR(r.books.friction, -2.0 / 9 * 0.7 * 25, 1e-9);
  EXPECT_NEAR(r.books.flight, 0, 1e-9);
  EXPECT_EQ(r.books.contacts, 0);
  EXPECT_NEAR(r.books.ground.linear.y() + r.books.wall.linear.y(), 9.81 * 10, 1e-9);
  EXPECT_GT(length(r.books.wall.linear), 1);
  expectClosed(r, 1e-12);
}

// Sliding on both, the wall presses the ball to the ground and the ground to the wall.
TEST(Books, OfABallWedgedIntoTheCornerClose) {
  World world = makeScene(findScene("corner-slide-to-roll"));
  world.balls.spin[0] = {0, 0, -20};
  const BookedRun r = run(world, 20);
  EXPECT_LT(r.books.friction, -1);
  EXPECT_NEAR(r.books.flight, 0, 1e-7);
  EXPECT_EQ(r.books.contacts, 0);
  expectClosed(r, 1e-12);
}

// A ball that falls from the height 5 m keeps e^2 of its energy at each impact.
TEST(Books, BouncesLoseWhatRestitutionTakes) {
  const BookedRun r =
      run(oneBall(0.5, 0.3, {{0, 5.5, 0}}), 100);  // t = 1.667: one impact, at 1.0096
  EXPECT_NEAR(r.books.contacts, -(1 - 0.25) * 2 * 9.81 * 5, 1e-11);
  EXPECT_EQ(r.books.friction, 0);
  EXPECT_NEAR(r.books.ground.linear.y(), 2 * 1.5 * std::sqrt(2 * 9.81 * 5), 1e-11);
  expectClosed(r, 1e-13);
}

// Drag alone: the velocity falls by the factor d in a second, so the energy by d^2.
TEST(Books, DragTakesItsShare) {
  World world = oneBall(1, 0, {{0, 5, 0}, {3, 0, 0}});
  world.settings.gravity = Vec3::Zero();
  world.settings.drag = 0.5;
  const BookedRun r = run(world, 60);
  EXPECT_NEAR(r.books.drag, -9 * 0.75, 1e-9);  // the integrator's error of the fourth order
  expectClosed(r, 1e-13);
}

// A well that is switched on lowers the potential of a ball at distance d by S / sqrt(d^2 + eps^2).
TEST(Books, SwitchedWellsAndSetStatesAreBooked) {
  World world = oneBall(1, 0, {{0, 5, 0}});
  world.settings.gravity = Vec3::Zero();
  world.tracks = {{.keyframes = {{0, {3, 5, 0}, 0}, {10, {3, 5, 0}, 100}}, .softening = 2}};
  const auto simulation = makeSimulation();
  simulation->openBooks();
  for (int i = 0; i < 11; ++i) simulation->step(world);
  EXPECT_NEAR(simulation->books()->wells, -2 * 100 / std::sqrt(13.0), 1e-11);
  EXPECT_EQ(simulation->books()->outside, 0);
  const double before = measure(world).kineticEnergy;
  world.balls.velocity[0] += Vec3(0, 0, 4);
  const double given = measure(world).kineticEnergy - before;
  simulation->step(world);
  EXPECT_NEAR(simulation->books()->outside, given, 1e-12);
  EXPECT_NEAR(simulation->books()->changes.linear.z(), 8, 1e-14);
}

// Everything at once, in each method: moving wells, drag, friction, a heap.
TEST(Books, CloseForACollapsingHeap) {
  for (const ContactMethod method :
       {ContactMethod::Auto, ContactMethod::Exact, ContactMethod::Substep}) {
    World world = makeScene(findScene("T1"), 200);
    world.settings.contactMethod = method;
    world.settings.drag = 0.9;
    for (WellTrack& track : world.tracks) {
      const WellKeyframe first = track.keyframes.front();
      track.keyframes.push_back({200, first.position + Vec3(4, 1, -3), first.strength});
    }
    const BookedRun r = run(world, 200);
    expectClosed(r, 1e-12);
    EXPECT_LT(r.books.contacts, 0);
    EXPECT_LT(r.books.friction, 0);
    EXPECT_LT(r.books.drag, 0);
    EXPECT_NE(r.books.wells, 0);
    EXPECT_LE(std::abs(r.books.flight), 1e-4 * std::abs(r.books.contacts));
  }
}

TEST(Books, CloseForAGas) {
  const BookedRun r = run(makeScene(findScene("T2"), 1000), 100);
  expectClosed(r, 1e-13);
  EXPECT_LE(std::abs(r.books.contacts), 1e-12 * r.end.kineticEnergy);
  EXPECT_EQ(r.books.friction, 0);
  EXPECT_EQ(length(r.books.fields.linear), 0);
}

// Keeping books changes nothing.
TEST(Books, DoNotChangeTheWorld) {
  World booked = makeScene(findScene("T1"), 150);
  World plain = booked;
  const auto a = makeSimulation();
  const auto b = makeSimulation();
  a->openBooks();
  for (int i = 0; i < 150; ++i) {
    a->step(booked);
    b->step(plain);
  }
  EXPECT_EQ(stateHash(booked), stateHash(plain));
  EXPECT_EQ(b->books(), nullptr);
}

}  // namespace
}  // namespace wells
