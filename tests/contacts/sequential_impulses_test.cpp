#include "contacts/sequential_impulses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/elementary.h"
#include "math/random.h"

namespace wells {
namespace {

constexpr double kSubstep = 1.0 / 240;

struct Scene {
  Settings settings;
  Arena arena;
  Balls balls;
  std::vector<Contact> ballContacts;
  std::vector<Contact> arenaContacts;
  ContactWorkspace workspace;

  /// Resolves with the velocities that the balls have, as if no force had acted.
  void resolve() {
    const std::vector<Vec3> before = balls.velocity;
    resolveContacts(settings, arena, kSubstep, {ballContacts, arenaContacts}, before.data(), balls,
                    workspace);
  }
};

Scene twoBalls(const Vec3& normal, double massA, double massB, double e, double mu) {
  Scene scene;
  scene.settings.elasticity = e;
  scene.settings.friction = mu;
  scene.balls.add({.position = {0, 5, 0}}, 0.5, massA);
  scene.balls.add({.position = Vec3(0, 5, 0) + normal * (1 - 1e-12)}, 0.5, massB);
  scene.ballContacts = {{.a = 0, .b = 1}};
  return scene;
}

// Head-on: v_a' = v (m_a - e m_b) / (m_a + m_b), v_b' = v m_a (1 + e) / (m_a + m_b).
TEST(Restitution, HeadOnImpactOfTwoMasses) {
  for (const double e : {0.0, 0.3, 0.8, 1.0})
    for (const double massB : {0.01, 1.0, 7.0}) {
      Scene scene = twoBalls({1, 0, 0}, 2, massB, e, 0);
      scene.balls.velocity[0] = {3, 0, 0};
      scene.resolve();
      EXPECT_NEAR(scene.balls.velocity[0].x(), 3 * (2 - e * massB) / (2 + massB), 1e-14);
      EXPECT_NEAR(scene.balls.velocity[1].x(), 3 * 2 * (1 + e) / (2 + massB), 1e-14);
    }
}

// A (0,1,0) v = (5,0,0) at rest B (3,1,.4): at impact the centres are 0.4 apart across the line.
TEST(Restitution, ObliqueImpactOfTwoBalls) {
  const double along = std::sqrt(1 - 0.4 * 0.4);
  Scene scene = twoBalls({along, 0, 0.4}, 1, 1, 1, 0);
  scene.balls.velocity[0] = {5, 0, 0};
  scene.resolve();
  EXPECT_LE(length(scene.balls.velocity[0] - Vec3(0.8, 0, -1.833030277982336)), 1e-14);
  EXPECT_LE(length(scene.balls.velocity[1] - Vec3(4.2, 0, 1.833030277982336)), 1e-14);
}

// Two balls of any radii and masses rest on each other with the normal impulse J and turn against
// each other. The torque's impulse is what ends that, 1/(1/I_a + 1/I_b), or b J; equal and
// opposite, and the spin about the normal stays. Friction is off, so that nothing else turns them.
TEST(RollingResistance, EndsTheRollingOfTwoBalls) {
  for (const double resistance : {1e-3, 1.0}) {
    Scene scene;
    scene.settings.elasticity = 0;
    scene.settings.friction = 0;
    scene.settings.rollingResistance = resistance;
    const Vec3 normal(0.6, 0, 0.8);
    const Vec3 axis(0, 1, 0);
    scene.balls.add({.position = {0, 5, 0}, .velocity = normal, .spin = 2 * axis + 3 * normal}, 0.5,
                    2);
    scene.balls.add({.position = Vec3(0, 5, 0) + normal * (0.75 - 1e-12), .spin = -axis}, 0.25, 1);
    scene.ballContacts = {{.a = 0, .b = 1}};
    // As if a force had closed them: no impact.
    const std::vector<Vec3> before = {Vec3::Zero(), Vec3::Zero()};
    resolveContacts(scene.settings, scene.arena, kSubstep, {scene.ballContacts, {}}, before.data(),
                    scene.balls, scene.workspace);
    const double inertiaA = 0.4 * 2 * 0.25, inertiaB = 0.4 * 1 * 0.0625;
    const double needed = 3 / (1 / inertiaA + 1 / inertiaB);
    const double impulse = std::min(needed, resistance * 2.0 / 3);  // J = m* v, m* = 2/3
    EXPECT_NEAR(scene.ballContacts[0].normalImpulse, 2.0 / 3, 1e-12);
    EXPECT_LE(length(scene.balls.spin[0] - (2 - impulse / inertiaA) * axis - 3 * normal), 1e-12);
    EXPECT_LE(length(scene.balls.spin[1] + (1 - impulse / inertiaB) * axis), 1e-12);
  }
}

// An impact is an instant: what its normal force does to the rolling is not modelled.
TEST(RollingResistance, IsNoneWithinAnImpact) {
  Scene scene = twoBalls({1, 0, 0}, 1, 1, 0.5, 0);
  scene.settings.rollingResistance = 0.1;
  scene.balls.velocity[0] = {3, 0, 0};
  scene.balls.spin[0] = {0, 5, 0};
  scene.resolve();
  EXPECT_GT(scene.balls.velocity[1].x(), 1);
  EXPECT_EQ(scene.balls.spin[0], Vec3(0, 5, 0));
}

// Two equal balls with friction, m* = 1/2. J_n = (1+e) m* v_n; J_t = 2/7 m* u_t where they stick,
// else mu J_n. Normal (cos 30, 0, sin 30), 5 m/s, e = 0.8, mu = 0.3: they stick.
TEST(Friction, TwoBallsThatStick) {
  const double c = std::sqrt(3.0) / 2;
  Scene scene = twoBalls({c, 0, 0.5}, 1, 1, 0.8, 0.3);
  scene.balls.velocity[0] = {5, 0, 0};
  scene.resolve();
  EXPECT_LE(length(scene.balls.velocity[0] - Vec3(1.44642857142857, 0, -1.63926237)), 1e-8);
  EXPECT_LE(length(scene.balls.velocity[1] - Vec3(3.55357142857143, 0, 1.63926237)), 1e-8);
  for (const Vec3& spin : scene.balls.spin)
    EXPECT_LE(length(spin - Vec3(0, -1.78571428571429, 0)), 1e-13);
}

// The same head-on with 20 rad/s about z: u_t = 10 m/s > 7/2 mu (1+e) v_n, they slip.
TEST(Friction, TwoBallsThatSlip) {
  Scene scene = twoBalls({1, 0, 0}, 1, 1, 0.8, 0.3);
  scene.balls.velocity[0] = {5, 0, 0};
  scene.balls.spin[0] = {0, 0, 20};
  scene.resolve();
  EXPECT_LE(length(scene.balls.velocity[0] - Vec3(0.5, -1.35, 0)), 1e-14);
  EXPECT_LE(length(scene.balls.velocity[1] - Vec3(4.5, 1.35, 0)), 1e-14);
  EXPECT_LE(length(scene.balls.spin[0] - Vec3(0, 0, 13.25)), 1e-13);
  EXPECT_LE(length(scene.balls.spin[1] - Vec3(0, 0, -6.75)), 1e-13);
}

// Oblique impact on the ground at 5 m/s, theta from the normal, e = 0.8, mu = 0.3: slides if
// tan(theta) >= 7/2 mu (1 + e), then v_t' = v_t - mu (1+e) v_n and r|w'| = 5/2 mu (1+e) v_n; else
// v_t' = r|w'| = 5/7 v_t.
TEST(Friction, ObliqueImpactOnTheGroundOverAllAngles) {
  for (int degrees = 5; degrees <= 85; degrees += 5) {
    const SinCos angle = sinCosOfTurns(degrees / 360.0);
    const double tangential = 5 * angle.sin;
    const double normal = 5 * angle.cos;
    Scene scene;
    scene.settings.elasticity = 0.8;
    scene.settings.friction = 0.3;
    scene.balls.add({.position = {0, 0.5 - 1e-12, 0}, .velocity = {tangential, -normal, 0}}, 0.5,
                    1);
    scene.arenaContacts = {{.a = 0, .b = kGround}};
    scene.resolve();
    const bool slides = angle.sin / angle.cos >= 3.5 * 0.3 * 1.8;
    const double after = slides ? tangential - 0.3 * 1.8 * normal : 5.0 / 7 * tangential;
    const double rolling = slides ? 2.5 * 0.3 * 1.8 * normal : 5.0 / 7 * tangential;
    EXPECT_NEAR(scene.balls.velocity[0].x(), after, 1e-14) << degrees;
    EXPECT_NEAR(scene.balls.velocity[0].y(), 0.8 * normal, 1e-14) << degrees;
    EXPECT_NEAR(scene.balls.spin[0].z(), -rolling / 0.5, 1e-13) << degrees;
  }
}

// The wall's normal at (x, z) is the radius; a ball that runs along it is not held.
TEST(Geometry, WallIsACylinderAndGroundAPlane) {
  const Arena arena{.center = {100, -3, 7}, .radius = 10};
  Balls balls;
  balls.add({.position = {100 + 6, 1, 7 - 8}}, 0.5, 1);
  Contact wall{.a = 0, .b = kWall};
  touchArena(arena, balls, wall);
  EXPECT_NEAR(wall.gap, 10 - 0.5 - 10, 1e-14);
  EXPECT_LE(length(wall.normal - Vec3(0.6, 0, -0.8)), 1e-15);
  EXPECT_EQ(wall.gap, wallGap(arena, balls.position[0], 0.5));
  Contact ground{.a = 0, .b = kGround};
  touchArena(arena, balls, ground);
  EXPECT_EQ(ground.gap, 3.5);
  EXPECT_EQ(ground.normal, Vec3(0, -1, 0));
}

TEST(Geometry, NormalPointsFromAToB) {
  Balls balls;
  balls.add({.position = {1, 1, 1}}, 0.5, 1);
  balls.add({.position = {1, 4, 5}}, 2, 1);
  Contact c{.a = 0, .b = 1};
  touchBalls(balls, c);
  EXPECT_NEAR(c.gap, 5 - 2.5, 1e-15);
  EXPECT_LE(length(c.normal - Vec3(0, 0.6, 0.8)), 1e-15);
  balls.position[1] = balls.position[0];
  touchBalls(balls, c);
  EXPECT_EQ(c.gap, -2.5);
  EXPECT_EQ(length(c.normal), 1);
}

// What gravity builds up within the substep is no impact: the ball stays, to the bit of its height.
TEST(RestingRule, BallOnTheGroundStays) {
  Scene scene;
  scene.settings.elasticity = 1;
  scene.balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
  scene.arenaContacts = {{.a = 0, .b = kGround}};
  for (int substep = 0; substep < 1000; ++substep) {
    const Vec3 before = scene.balls.velocity[0];
    scene.balls.position[0].y() += before.y() * kSubstep - 9.81 * kSubstep * kSubstep / 2;
    scene.balls.velocity[0].y() -= 9.81 * kSubstep;
    resolveContacts(scene.settings, scene.arena, kSubstep, {{}, scene.arenaContacts}, &before,
                    scene.balls, scene.workspace);
    ASSERT_NEAR(scene.balls.position[0].y(), 0.5, 1e-15);
    ASSERT_EQ(scene.balls.velocity[0].y(), 0);
  }
}

TEST(RestingRule, WithoutForceEvenTheSlowestImpactBounces) {
  Scene scene = twoBalls({1, 0, 0}, 1, 1, 1, 0);
  scene.balls.velocity[0] = {1e-9, 0, 0};
  scene.resolve();
  EXPECT_EQ(scene.balls.velocity[0].x(), 0);
  EXPECT_EQ(scene.balls.velocity[1].x(), 1e-9);
}

TEST(Contacts, SeparatingBallsAreLeftAlone) {
  Scene scene = twoBalls({1, 0, 0}, 1, 1, 0.5, 0.5);
  scene.balls.velocity[1] = {2, 1, 0};
  scene.resolve();
  EXPECT_EQ(scene.balls.velocity[0], Vec3(0, 0, 0));
  EXPECT_EQ(scene.balls.velocity[1], Vec3(2, 1, 0));
}

// Impulses come in opposite pairs: in a random heap away from the arena momentum stays, and at e =
// 0 kinetic energy falls. (Overlapping balls have no common contact point, so angular momentum is
// tested on pairs that just touch.)
TEST(Contacts, HeapKeepsMomentumAndLosesEnergy) {
  Random random(1);
  Scene scene;
  scene.settings.elasticity = 0;
  scene.settings.friction = 0.4;
  for (int i = 0; i < 60; ++i)
    scene.balls.add({.position = Vec3(0, 100, 0) + 1.5 * random.direction() * random.uniform(),
                     .velocity = 3 * random.direction(),
                     .spin = 5 * random.direction()},
                    random.uniform(0.2, 0.6), random.uniform(0.5, 3));
  const Balls& b = scene.balls;
  for (std::uint32_t i = 0; i < b.size(); ++i)
    for (std::uint32_t j = i + 1; j < b.size(); ++j)
      if (length(b.position[i] - b.position[j]) < b.radius[i] + b.radius[j])
        scene.ballContacts.push_back({.a = i, .b = j});
  ASSERT_GT(scene.ballContacts.size(), 200u);

  Vec3 momentum = Vec3::Zero();
  double energy = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    momentum += b.mass[i] * b.velocity[i];
    energy += b.mass[i] * (squaredLength(b.velocity[i]) +
                           kInertiaFactor * b.radius[i] * b.radius[i] * squaredLength(b.spin[i]));
  }
  scene.resolve();
  for (std::size_t i = 0; i < b.size(); ++i) {
    momentum -= b.mass[i] * b.velocity[i];
    energy -= b.mass[i] * (squaredLength(b.velocity[i]) +
                           kInertiaFactor * b.radius[i] * b.radius[i] * squaredLength(b.spin[i]));
  }
  EXPECT_LE(length(momentum), 1e-11);
  EXPECT_GT(energy, 0);
}

TEST(Contacts, PairThatJustTouchesKeepsAngularMomentum) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 normal = random.direction();
    Scene scene = twoBalls(normal, 1, 3, 0.7, 0.5);
    scene.balls.radius = {0.3, 0.7};
    scene.balls.velocity = {Vec3(4 * normal + random.direction()), random.direction()};
    scene.balls.spin = {Vec3(9 * random.direction()), Vec3(9 * random.direction())};
    const auto angularMomentum = [&] {
      Vec3 sum = Vec3::Zero();
      for (std::size_t i = 0; i < 2; ++i)
        sum += scene.balls.mass[i] * (cross(scene.balls.position[i], scene.balls.velocity[i]) +
                                      kInertiaFactor * scene.balls.radius[i] *
                                          scene.balls.radius[i] * scene.balls.spin[i]);
      return sum;
    };
    const Vec3 before = angularMomentum();
    scene.resolve();
    EXPECT_LE(length(angularMomentum() - before), 1e-10);
  }
}

// Overlap is pushed out without a change of velocity.
TEST(PushOut, MovesBallsApartAtRest) {
  Scene scene = twoBalls({1, 0, 0}, 1, 3, 0.5, 0.5);
  scene.balls.position[1] = scene.balls.position[0] + Vec3(0.6, 0, 0);
  for (int i = 0; i < 40; ++i) scene.resolve();
  EXPECT_NEAR(length(scene.balls.position[1] - scene.balls.position[0]), 1, 1e-12);
  // By inverse mass: three times as far for the light one.
  EXPECT_NEAR(scene.balls.position[0].x(), -0.3, 1e-12);
  EXPECT_EQ(scene.balls.velocity[0], Vec3(0, 0, 0));
  EXPECT_EQ(scene.balls.velocity[1], Vec3(0, 0, 0));
}

// A clump of balls in one point bursts to all sides: the pushes of all pairs nearly cancel.
TEST(CoincidentBalls, GetDirectionsToAllSides) {
  Vec3 sum = Vec3::Zero();
  int pairs = 0;
  for (std::uint32_t a = 0; a < 40; ++a)
    for (std::uint32_t b = a + 1; b < 40; ++b, ++pairs) {
      const Vec3 direction = directionOfIds(a, b);
      EXPECT_NEAR(length(direction), 1, 1e-15);
      sum += direction;
    }
  EXPECT_LE(length(sum), 3 * std::sqrt(pairs));  // of a random walk, with room
}

}  // namespace
}  // namespace wells
