// One ball and the ground, with friction: sliding that becomes rolling, and oblique impacts.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/random.h"
#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "support/run_world.h"

namespace wells {
namespace {

// Slides until t1 = 2 (v0 + r w0) / (7 mu g), then rolls at v = (5 v0 - 2 r w0) / 7, w = -v / r.
// All pieces are parabolas, which rounding alone disturbs: 1e-9 m, 1e-12 m/s.
TEST(SlideToRoll, IsExactAtAnyStep) {
  for (const auto& [scene, speed] : {std::pair{"slide-to-roll", 3.571428571428571},
                                     {"backspin", 0.7142857142857143},
                                     {"backspin-return", -2.142857142857143}})
    for (const double rate : {6, 30, 60, 960}) {
      World world = makeScene(findScene(scene));
      world.settings.dt = 1 / rate;
      runFor(world, 3);
      EXPECT_LE(positionError(findAccuracyCase(scene), world), 1e-9) << scene << " " << rate;
      EXPECT_LE(length(world.balls.velocity[0] - Vec3(speed, 0, 0)), 1e-12) << scene << " " << rate;
      EXPECT_LE(length(world.balls.spin[0] - Vec3(0, 0, -speed / 0.5)), 2e-12)
          << scene << " " << rate;
    }
}

// On the way there, at every step: v = v0 - mu g t, w = w0 - 5/2 mu g t / r.
TEST(SlideToRoll, SlidesByTheFormula) {
  World world = makeScene(findScene("backspin"));
  const auto simulation = makeSimulation();
  for (int i = 1; i <= 87; ++i) {  // t1 = 1.456239988350080 s
    simulation->step(world);
    const double t = i / 60.0;
    EXPECT_NEAR(world.balls.position[0].x(), 5 * t - 0.3 * 9.81 / 2 * t * t, 1e-12);
    EXPECT_NEAR(world.balls.velocity[0].x(), 5 - 0.3 * 9.81 * t, 1e-12);
    EXPECT_NEAR(world.balls.spin[0].z(), 20 - 2.5 * 0.3 * 9.81 * t / 0.5, 2e-12);
    EXPECT_NEAR(world.balls.position[0].y(), 0.5, 1e-12);
  }
}

// Any start: friction along the slip turns it nowhere, so x and z go as above, each with its share.
TEST(SlideToRoll, InAnyDirection) {
  Random random(3);
  for (int seed = 0; seed < 20; ++seed) {
    World world;
    const Vec3 v{random.uniform(-5, 5), 0, random.uniform(-5, 5)};
    const Vec3 w{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)};
    world.balls.add({{0, 0.5, 0}, v, w}, 0.5, random.uniform(0.1, 10));
    // Of the surface on the ground: v + w x (0, -r, 0).
    const Vec3 slip = v + 0.5 * Vec3(w.z(), 0, -w.x());
    const double t1 = 2 * length(slip) / (7 * 0.3 * 9.81);
    ASSERT_LT(t1, 3);
    const Vec3 rolling = v - 2.0 / 7 * slip;
    runFor(world, 3);
    EXPECT_LE(length(world.balls.velocity[0] - rolling), 1e-12) << seed;
    const Vec3 end = Vec3(0, 0.5, 0) + (v + rolling) / 2 * t1 + rolling * (3 - t1);
    EXPECT_LE(length(world.balls.position[0] - end), 1e-9) << seed;
    EXPECT_NEAR(world.balls.spin[0].y(), w.y(), 1e-12) << "spin about the normal is not damped";
  }
}

// Slides through the impact if tan(theta) >= 7/2 mu (1 + e), by v_t' = v_t - mu (1 + e) v_n and
// r |w'| = 5/2 mu (1 + e) v_n; else v_t' = r |w'| = 5/7 v_t. One impact: rounding alone.
TEST(ObliqueImpact, OnTheGroundAtAllAngles) {
  const double e = 0.8, mu = 0.3;
  for (int degrees = 5; degrees <= 85; degrees += 5) {
    const double theta = degrees * std::numbers::pi / 180;
    const double tangential = 5 * std::sin(theta), normal = 5 * std::cos(theta);
    World world = makeScene(findScene("oblique-ground"));
    world.balls.velocity[0] = {tangential, -normal, 0};
    EXPECT_EQ(run(world, 120).impacts, 2) << degrees;
    const bool slides = std::tan(theta) >= 3.5 * mu * (1 + e);
    const double after = slides ? tangential - mu * (1 + e) * normal : 5.0 / 7 * tangential;
    const double rolling = slides ? 2.5 * mu * (1 + e) * normal : 5.0 / 7 * tangential;
    EXPECT_NEAR(world.balls.velocity[0].x() / after, 1, 1e-12) << degrees;
    EXPECT_NEAR(world.balls.velocity[0].y() / (e * normal), 1, 1e-12) << degrees;
    EXPECT_NEAR(world.balls.spin[0].z() / (-rolling / 0.5), 1, 1e-12) << degrees;
  }
}

// The numbers of the two angles about the threshold of 62.11665938 degrees, by the same formula.
TEST(ObliqueImpact, OnBothSidesOfSticking) {
  World world = makeScene(findScene("oblique-ground"));
  run(world, 120);
  EXPECT_NEAR(world.balls.velocity[0].x(), 3.092947870658709, 4e-12);
  EXPECT_NEAR(world.balls.spin[0].z(), -6.185895741317418, 7e-12);
  EXPECT_NEAR(world.balls.velocity[1].x(), 3.390469628483361, 4e-12);
  EXPECT_NEAR(world.balls.spin[1].z(), -5.705346533499443, 6e-12);
}

// Without friction nothing turns the balls or slows them on the ground, also where they had some
// until now: one that slides and one that spins.
TEST(Friction, EndsWhenItIsSwitchedOff) {
  for (const ContactMethod method : {ContactMethod::Substep, ContactMethod::Exact}) {
    World world;
    world.settings.contactMethod = method;
    world.balls.add({{0, 0.5, 0}, {5, 0, 0}, {0, 0, 0}}, 0.5, 1);
    world.balls.add({{0, 0.5, 5}, {0, 0, 0}, {20, 0, 0}}, 0.5, 1);
    const auto simulation = makeSimulation();
    for (int i = 0; i < 10; ++i) simulation->step(world);
    world.settings.friction = 0;
    const World before = world;
    EXPECT_LT(before.balls.velocity[0].x(), 4.9) << name(method) << ": no friction at all";
    for (int i = 0; i < 30; ++i) simulation->step(world);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(length(world.balls.velocity[i] - before.balls.velocity[i]), 1e-12) << name(method);
      EXPECT_EQ(world.balls.spin[i], before.balls.spin[i]) << name(method);
    }
  }
}

}  // namespace
}  // namespace wells
