// A ball that the wall holds: it runs round, slips, rolls and leaves, against closed forms and an
// independent path. The distance falls with the fourth power of dt: every change is located in
// time.
#include <gtest/gtest.h>

#include "scenes/unit_balls.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"
#include "support/order.h"
#include "support/step_errors.h"

namespace wells {
namespace {

constexpr double kArena = 10;            // m
constexpr double kRound = kArena - 0.5;  // m, from the axis to the centre of a ball at the wall

struct Case {
  const char* name;
  double friction;
  double gravity;  // m/s^2, downward
  Vec3 well;       // m
  double strength;
  double height;  // m, of the centre at the start, on the wall at x = 9.5
  Vec3 velocity, spin;
  bool leaves;
  double duration;  // s
  bool slipEndsTurning = false;
};

World worldOf(const Case& c, double dt) {
  World world;
  world.arena.radius = kArena;
  world.settings.dt = dt;
  world.settings.gravity = {0, -c.gravity, 0};
  world.settings.elasticity = 0.8;
  world.settings.friction = c.friction;
  if (c.strength != 0) world.tracks = {{.keyframes = {{0, c.well, c.strength}}, .softening = 2}};
  addUnitBall(world, {kRound, c.height, 0}, c.velocity, c.spin);
  return world;
}

/// Where it must be.
Vec3 endOf(const Case& c) {
  const World world = worldOf(c, 1);
  std::vector<oracle::SoftWell> wells{{oracle::pointOf(c.well), c.strength, 2}};
  oracle::Body body = oracle::bodiesOf(world)[0];
  const oracle::HeldUntil held =
      oracle::HeldBall(oracle::Support::Wall, wells, c.gravity, c.friction).move(body, c.duration);
  EXPECT_EQ(held.lifted, c.leaves) << c.name;
  if (!held.lifted) return oracle::vectorOf(body.x);
  oracle::Flyer flyer{body.x, body.v};
  oracle::TaylorFlight(wells, c.gravity).fly(flyer, c.duration - held.time);
  return oracle::vectorOf(flyer.x);
}

const Case kCases[] = {
    {"rolls_round_and_falls", 0.3, 9.81, {}, 0, 5, {0, 0, -38}, {0, -76, 0}, false, 10},
    {"rolls_with_spin_about_the_normal", 0.5, 9.81, {}, 0, 9, {0, 1, -30}, {3, -60, 2}, false, 5},
    {"rolls_under_a_well", 0.5, 9.81, {3, 16, 1}, 100, 16, {0, 0, -20}, {0, -40, 0}, false, 3},
    {"rolls_then_slips", 0.1, 9.81, {}, 0, 30, {0, 0, -20}, {0, -40, 0}, false, 2},
    {"slips_then_rolls", 0.3, 0, {0, 8, 0}, 40, 6, {0, 1, -12}, {0, 4, -6}, false, 5, true},
    {"slides_smoothly", 0, 9.81, {2, 9, 1}, 200, 9, {0, 0, -14}, {3, 1, 2}, false, 1},
    {"slips_and_leaves", 0.3, 0, {0, 8, -5}, 400, 8, {0, 0, -5.5}, {0, 3, 1}, true, 2},
    {"rolls_and_leaves", 0.9, 0, {0, 8, -5}, 400, 8.5, {0, 0, -5.5}, {0, -11, 0}, true, 2},
};

constexpr double kReference = 1e-10;  // m, the error of the independent path

class WallPath : public testing::TestWithParam<Case> {};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

TEST_P(WallPath, IsFollowed) {
  const Case& c = GetParam();
  auto errors = stepErrors([&](double dt) { return worldOf(c, dt); }, c.duration, endOf(c));
  while (errors.size() > 2 && errors.back().second <= kReference) errors.pop_back();
  EXPECT_LE(errors.front().second, 1e-6);
  // The ever shorter steps in which a slip turns as it ends are as coarse at any dt.
  if (c.slipEndsTurning)
    EXPECT_LE(errors.front().second, 1e-8);
  else
    EXPECT_GE(fittedOrder(errors), 3.8);
}

INSTANTIATE_TEST_SUITE_P(Cases, WallPath, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

// v_n = 0 is no impact: the speed stays, whatever the elasticity.
TEST(WallPath, AGalleryNeitherSlowsNorLeaves) {
  for (const double elasticity : {0.0, 0.5, 1.0}) {
    World world = freeWorld();
    world.arena.radius = kArena;
    world.settings.elasticity = elasticity;
    addUnitBall(world, {kRound, 1, 0}, {0, 0, -5});
    const RunCounts counts = runFor(world, 10);
    EXPECT_EQ(counts.substepBalls, 0);
    const Vec3 end(4.971754630580167, 1, 8.095162499499603);  // phi = v t / rho
    EXPECT_LE(length(world.balls.position[0] - end), 1e-12) << elasticity;
    EXPECT_NEAR(length(world.balls.velocity[0]), 5, 1e-12) << elasticity;
  }
}

// v' = -mu v^2 / rho until v = 5/7 v0.
TEST(WallPath, SlidingBecomesRolling) {
  World world = freeWorld();
  world.arena.radius = kArena;
  world.settings.friction = 0.3;
  addUnitBall(world, {kRound, 1, 0}, {0, 0, -5});
  runFor(world, 5);
  EXPECT_LE(length(world.balls.position[0] - Vec3(-4.370851029136777, 1, -8.434788751420748)),
            1e-9);
  EXPECT_NEAR(length(world.balls.velocity[0]), 25.0 / 7, 1e-10);
  EXPECT_NEAR(world.balls.spin[0].y(), -7.142857142857142, 1e-9);
}

}  // namespace
}  // namespace wells
