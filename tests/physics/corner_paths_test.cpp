// A ball that ground and wall hold at once: against closed forms, and against an independent path
// through all switches (a contact slips, grips, leaves). The distance falls with the fourth power
// of dt, so every switch is located in time.
#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "scenes/unit_balls.h"
#include "support/corner_ball.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"
#include "support/order.h"
#include "support/step_errors.h"
#include "world/measures.h"

namespace wells {
namespace {

constexpr double kArena = 10;            // m
constexpr double kRound = kArena - 0.5;  // m, from the axis to the centre of a ball at the wall

World cornerWorld(double friction, double speed, const Vec3& spin = Vec3::Zero()) {
  World world;
  world.arena.radius = kArena;
  world.settings.friction = friction;
  addUnitBall(world, {kRound, 0.5, 0}, {0, 0, -speed}, spin);
  return world;
}

/// On the circle, after `way` (m) along -z.
Vec3 placeAfter(double way) {
  return {kRound * std::cos(way / kRound), 0.5, -kRound * std::sin(way / kRound)};
}

TEST(CornerPath, SmoothGoesRound) {
  World world = cornerWorld(0, 5, {1, 2, 3});
  EXPECT_EQ(runFor(world, 10).substepBalls, 0);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(50)), 1e-12);
  EXPECT_EQ(world.balls.spin[0], Vec3(1, 2, 3));
}

// The normals of both are at 45 degrees to the axis about which it turns.
TEST(CornerPath, RollsOnBoth) {
  World world = cornerWorld(0.5, 5, {-10, -10, 0});
  EXPECT_EQ(runFor(world, 10).substepBalls, 0);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(50)), 1e-12);
  EXPECT_NEAR(length(world.balls.velocity[0]), 5, 1e-12);
  EXPECT_NEAR(world.balls.spin[0].y(), -10, 1e-12);
}

// 1/2 + 1/5 + 1/5 of m v^2: drag takes 5/9 of what it takes of a ball in flight.
TEST(CornerPath, DragSlowsRollingByFiveNinths) {
  World world = cornerWorld(0.5, 5, {-10, -10, 0});
  world.settings.drag = 0.9;
  EXPECT_EQ(runFor(world, 5).substepBalls, 0);
  EXPECT_NEAR(length(world.balls.velocity[0]), 5 * std::pow(0.9, 5 * 5.0 / 9), 1e-12);
}

// A slip across both contacts (spin about the direction of motion) wedges the ball in: at rest
// N_w = mu N_g, N_g = g / (1 + mu^2), and the surface's speed b falls by 5/2 mu (N_w + N_g) a
// second.
TEST(CornerPath, SpinAcrossWedgesTheBallIn) {
  const double mu = 0.3;
  World world = cornerWorld(mu, 0, {0, 0, -20});  // b = r w = -10 m/s
  EXPECT_EQ(runFor(world, 0.5).substepBalls, 0);
  const double slows = 2.5 * mu * (1 + mu) * 9.81 / (1 + mu * mu);
  EXPECT_NEAR(world.balls.spin[0].z(), -(10 - 0.5 * slows) / 0.5, 1e-12);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(0)), 1e-14);
  EXPECT_EQ(runFor(world, 1.5).substepBalls, 0);
  EXPECT_NEAR(world.balls.spin[0].z(), 0, 1e-9);
}

// Rolling on the ground, sliding along the wall: N_w = 7/5 v^2 / rho, so v' = -mu v^2 / rho, and
// the wall's slip is used up when v = 7/9 v0.
TEST(CornerPath, SlidingBecomesRollingOnBoth) {
  World world = cornerWorld(0.3, 5, {-10, 0, 0});
  EXPECT_EQ(runFor(world, 10).substepBalls, 0);
  const double t1 = 2.0 / 7 * kRound / (0.3 * 5);
  const double way = kRound / 0.3 * std::log(9.0 / 7) + 35.0 / 9 * (10 - t1);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(way)), 1e-10);
  EXPECT_NEAR(length(world.balls.velocity[0]), 35.0 / 9, 1e-11);
}

// Without friction the bounces at the wall are chords of ever smaller angle, atan(u / v) on either
// side, u the speed outward, which falls to e u at each; then the ball runs round at v.
TEST(CornerPath, BouncesAtTheWallEndThere) {
  World world = cornerWorld(0, 5);
  world.settings.elasticity = 0.5;
  world.balls.velocity[0].x() = -2;
  double time = 0, turned = 0;
  for (double u = 2; u > 1e-14; u *= 0.5) {
    time += 2 * kRound * u / (u * u + 25);
    turned += 2 * std::atan(u / 5);
  }
  ASSERT_LT(time, 4);
  EXPECT_EQ(runFor(world, 6).substepBalls, 0);
  const double way = turned * kRound + 5 * (6 - time);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(way)), 1e-7);
  EXPECT_NEAR(length(world.balls.velocity[0]), 5, 1e-9);
}

// It bounces on the ground along the wall, until both hold it.
TEST(CornerPath, BouncesOnTheGroundEndThere) {
  World world = cornerWorld(0, 5);
  world.settings.elasticity = 0.5;
  world.balls.position[0].y() = 1.5;
  EXPECT_EQ(runFor(world, 4).substepBalls, 0);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(20)), 1e-12);
}

// Whatever it starts with: slides, rolls, hops off one surface and comes back to it, all at its own
// times. Friction adds no energy, but for the finite steps through a slip that turns as it begins.
TEST(CornerPath, AnyStartIsFollowedAndGainsNoEnergy) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    World world = cornerWorld(random.uniform(0.05, 0.9), random.uniform(-8, 8),
                              random.uniform(0, 25) * random.direction());
    const auto simulation = makeSimulation();
    double energy = measure(world).energy();
    for (int step = 0; step < 200; ++step) {
      simulation->step(world);
      ASSERT_EQ(simulation->counts().substepBalls, 0) << trial << " " << step;
      const double now = measure(world).energy();
      ASSERT_LE(now, energy * (1 + 1e-6)) << trial << " " << step;
      energy = now;
    }
  }
}

struct Case {
  const char* name;
  double friction;
  double speed;  // m/s, along -z at x = rho
  Vec3 spin;     // rad/s
  Vec3 well;     // m
  double strength;
  oracle::CornerFate fate;
  double duration;  // s
  bool slipTurns = false;
  double drag = 0;  // 1/s
};

World worldOf(const Case& c, double dt) {
  World world = cornerWorld(c.friction, c.speed, c.spin);
  world.settings.dt = dt;
  world.settings.drag = std::exp(-c.drag);
  if (c.strength != 0) world.tracks = {{.keyframes = {{0, c.well, c.strength}}, .softening = 2}};
  return world;
}

/// Where it must be. What it leaves it must not meet again.
Vec3 endOf(const Case& c) {
  const World world = worldOf(c, 1);
  std::vector<oracle::SoftWell> wells{{oracle::pointOf(c.well), c.strength, 2}};
  oracle::Body body = oracle::bodiesOf(world)[0];
  const oracle::CorneredUntil held =
      oracle::CornerBall(wells, 9.81L, c.friction, c.drag).move(body, c.duration);
  EXPECT_EQ(held.fate, c.fate) << c.name << " at " << static_cast<double>(held.time);
  if (held.fate != oracle::CornerFate::Held)
    oracle::HeldBall(
        held.fate == oracle::CornerFate::LeftWall ? oracle::Support::Ground : oracle::Support::Wall,
        wells, 9.81L, c.friction)
        .move(body, c.duration - held.time);
  return oracle::vectorOf(body.x);
}

constexpr auto kHeld = oracle::CornerFate::Held;
constexpr auto kLeavesWall = oracle::CornerFate::LeftWall;
constexpr auto kLeavesGround = oracle::CornerFate::LeftGround;

const Case kCases[] = {
    {"rolls_under_a_well", 0.3, 6, {-12, -12, 0}, {9, 6, 4}, 300, kHeld, 3},
    {"rolls_from_rest", 0.4, 0, {0, 0, 0}, {12, 0.5, 8}, 200, kHeld, 2},
    {"slides_on_the_ground", 0.3, 0, {20, 0, 0}, {12, 1, 0}, 300, kHeld, 2},
    {"slides_smoothly", 0, 3, {1, 2, 3}, {5, 0.5, -9}, 100, kHeld, 2},
    {"slips_from_rolling_on_both", 0.4, 5, {-10, -10, 0}, {5, 0.5, -9}, 100, kHeld, 2},
    {"smoothly_leaves_the_wall", 0, 8, {0, 0, 0}, {3, 0.5, -7}, 300, kLeavesWall, 1},
    {"smoothly_leaves_the_ground", 0, 6, {0, 0, 0}, {7, 4, -7}, 400, kLeavesGround, 1.2},
    {"slides_and_leaves_the_wall", 0.3, 8, {-3, 0, 0}, {3, 0.5, -7}, 300, kLeavesWall, 1.1},
    {"slides_and_leaves_the_ground", 0.3, 6, {-3, 0, 0}, {9, 4, -7}, 400, kLeavesGround, 0.6},
    {"slides_on_both_then_rolls", 0.5, 5, {0, 0, -5}, {}, 0, kHeld, 2, true},
    {"slides_on_both_with_drag", 0.5, 5, {3, -8, -5}, {}, 0, kHeld, 2, true, 0.2},
    {"slips_on_both_at_once", 0.1, 5, {-10, -10, 0}, {9, 3, -6}, 80, kHeld, 1, true},
    {"slips_slowly_on_the_wall", 0.3, 5, {0, -10, 0}, {}, 0, kHeld, 3, true},
};

class CornerPathOf : public testing::TestWithParam<Case> {};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

constexpr double kReference = 1e-12;  // m, the error of the independent path

TEST_P(CornerPathOf, IsFollowed) {
  const Case& c = GetParam();
  auto errors = stepErrors([&](double dt) { return worldOf(c, dt); }, c.duration, endOf(c));
  while (errors.size() > 2 && errors.back().second <= kReference) errors.pop_back();
  // The ever shorter steps in which a slip turns as it begins or ends are as coarse at any dt.
  if (c.slipTurns)
    EXPECT_LE(errors.front().second, 5e-8);
  else
    EXPECT_GE(fittedOrder(errors), 3.8);
  EXPECT_LE(errors.front().second, 3e-7);
}

INSTANTIATE_TEST_SUITE_P(Cases, CornerPathOf, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace wells
