// The substeps on scenes with exact answers (the other files here have the exact method). They are
// of first order through an impact (noticed at the end of a substep) and of the integrator's order
// elsewhere; the bounds follow from that.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/catalogue.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

World run(World world, double dt, double duration) {
  world.settings.dt = dt;
  world.settings.contactMethod = ContactMethod::Substep;
  const auto simulation = makeSimulation();
  const auto steps = static_cast<int>(std::lround(duration / dt));
  for (int i = 0; i < steps; ++i) simulation->step(world);
  return world;
}

World scene(const char* name) {
  return makeScene(findScene(name));
}

// A bounce is noticed inside the ground and reflected there, where the energy is what it was; what
// leaves by itself is not pushed out. Free flight under gravity is exact. Rounding remains.
TEST(ElasticBounce, KeepsItsEnergy) {
  for (const double dt : {1.0 / 6, 1.0 / 30, 1.0 / 60, 1.0 / 960}) {
    const World start = scene("bounce");
    const World end = run(start, dt, 10);
    EXPECT_NEAR(measure(end).energy() / measure(start).energy(), 1, 1e-12) << "dt " << dt;
  }
}

// y(10) = 5.454441153150668 after 5 bounces; each is late by up to a substep h, which costs 2 v h
// in position, v = sqrt(2 g 5).
TEST(ElasticBounce, IsLateByUpToASubstepABounce) {
  for (const double dt : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
    const World end = run(scene("bounce"), dt, 10);
    const double speed = std::sqrt(2 * 9.81 * 5);
    EXPECT_NEAR(end.balls.position[0].y(), 5.454441153150668, 5 * 2 * speed * dt / 4);
  }
}

// Slides until t1 = 2 v0 / (7 mu g), then rolls at 5/7 v0: x(3) = 11.06100952103573. Only the
// substep in which it begins to roll is in error: by up to 2/7 of the slip that one substep
// removes, over half of it in time.
TEST(SlideToRoll, IsExactButForTheSubstepThatEndsTheSlide) {
  for (const double dt : {1.0 / 60, 1.0 / 240}) {
    const World end = run(scene("slide-to-roll"), dt, 3);
    const double h = dt / 4;
    EXPECT_NEAR(end.balls.position[0].x(), 11.06100952103573, 0.3 * 9.81 * h * h);
    EXPECT_NEAR(end.balls.velocity[0].x(), 25.0 / 7, 1e-12);
    EXPECT_NEAR(end.balls.spin[0].z(), -50.0 / 7, 1e-12);
    EXPECT_NEAR(end.balls.position[0].y(), 0.5, 1e-12);
  }
}

// Momentum and energy of the three balls are kept whenever the hits are noticed; the positions at
// t = 3 converge with the first power of the step.
TEST(Billiard, ConvergesAndConserves) {
  const Vec3 exact(15.12019672390261, 1, 4.170843163036978);  // of the last ball
  for (const double dt : {1.0 / 60, 1.0 / 240, 1.0 / 960, 1.0 / 3840}) {
    const World end = run(scene("billiard"), dt, 3);
    // The first hit turns by up to v h, which the second magnifies by about distance / diameter = 5
    // and the way of 10 m from there makes a distance.
    EXPECT_LE(length(end.balls.position[2] - exact), 5 * (dt / 4) * 5 * 10 / 2) << "dt " << dt;
    const Measures m = measure(end);
    EXPECT_NEAR(m.kineticEnergy, 12.5, 1e-13);
    EXPECT_LE(length(m.momentum - Vec3(5, 0, 0)), 1e-13);
  }
}

// Hits at equal angles: the distance of the chords from the axis is 3 sin 90 = 3 m, kept by angular
// momentum about the axis, and the speed is kept.
TEST(CircleBilliard, KeepsSpeedAndAngularMomentum) {
  const World end = run(scene("circle-billiard"), 1.0 / 60, 1000);
  EXPECT_NEAR(length(end.balls.velocity[0]), 5, 1e-11);
  EXPECT_NEAR(measure(end).angularMomentum.y(), 15, 1e-10);
  EXPECT_EQ(measure(end).escaped, 0);
}

}  // namespace
}  // namespace wells
