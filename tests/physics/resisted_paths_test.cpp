// Rolling resistance on ground and wall, beside wells and through all switches, against independent
// paths.
#include <gtest/gtest.h>

#include <string>

#include "scenes/unit_balls.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"
#include "support/order.h"
#include "support/step_errors.h"

namespace wells {
namespace {

constexpr double kG = 9.81;  // m/s^2
constexpr double kR = 0.5;   // m

struct Case {
  const char* name;
  double friction, resistance;
  oracle::Support support;
  Vec3 well;  // m
  double strength;
  Vec3 start, velocity, spin;
  double duration;  // s
  bool endsTurning = false;
};

World worldOf(const Case& c, double dt) {
  World world;
  if (c.support == oracle::Support::Wall) world.arena.radius = 10;
  world.settings.dt = dt;
  world.settings.friction = c.friction;
  world.settings.rollingResistance = c.resistance;
  world.tracks = {{.keyframes = {{0, c.well, c.strength}}, .softening = 2}};
  addUnitBall(world, c.start, c.velocity, c.spin);
  return world;
}

Vec3 endOf(const Case& c) {
  oracle::Body body = oracle::bodiesOf(worldOf(c, 1))[0];
  const oracle::HeldUntil held =
      oracle::HeldBall(c.support, {{oracle::pointOf(c.well), c.strength, 2}}, kG, c.friction,
                       c.resistance)
          .move(body, c.duration);
  EXPECT_FALSE(held.lifted) << c.name;
  return oracle::vectorOf(body.x);
}

constexpr auto kGround = oracle::Support::Ground;
constexpr auto kWall = oracle::Support::Wall;
const Case kCases[] = {
    {"rolls_round_a_well", 0.5, 0.02, kGround, {0, 2, 0}, 60, {4, kR, 1}, {0, 0, 1}, {2, 0, 0}, 4},
    {"starts_from_rest", 0.5, 0.02, kGround, {0, 2, 0}, 60, {4, kR, 1}, {0, 0, 0}, {0, 0, 0}, 4},
    {"stops_while_it_turns",
     0.5,
     0.1,
     kGround,
     {0, 0.5, 0},
     8,
     {2, kR, 0},
     {0, 0, 1},
     {2, 0, 0},
     2,
     true},
    {"slides_then_rolls",
     0.3,
     0.05,
     kGround,
     {0, 2, 0},
     20,
     {4, kR, 1},
     {-3, 0, 0},
     {0, 2, 5},
     2,
     true},
    {"rolls_then_slides", 0.1, 0.02, kGround, {0, 0.5, 0}, 60, {6, kR, 0}, {0, 0, 0}, {0, 0, 0}, 3},
    {"skids_without_turning",
     0.1,
     0.1,
     kGround,
     {0, 0.5, 0},
     60,
     {6, kR, 0},
     {0, 0, 1},
     {0, 0, 0},
     2},
    {"is_pressed_up_the_wall",
     0.5,
     0.02,
     kWall,
     {0, 30, 0},
     -2e4,
     {9.5, 31, 0},
     {0, 0, 0},
     {0, 0, 0},
     1},
    {"falls_rolling_round_the_wall",
     0.5,
     0.05,
     kWall,
     {0, 8, 0},
     10,
     {9.5, 40, 0},
     {0, 0, -20},
     {0, -40, 0},
     2},
    {"rolls_on_the_wall_with_spin",
     0.5,
     0.02,
     kWall,
     {0, 8, 0},
     10,
     {9.5, 9, 0},
     {0, 1, -30},
     {3, -60, -2},
     2},
    {"slides_then_rolls_on_the_wall",
     0.5,
     0.02,
     kWall,
     {0, 8, 0},
     10,
     {9.5, 9, 0},
     {0, 1, -30},
     {3, -60, 2},
     2,
     true},
};

constexpr double kReference = 1.5e-10;  // m, the error of the independent path

class ResistedPath : public testing::TestWithParam<Case> {};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

TEST_P(ResistedPath, IsFollowed) {
  const Case& c = GetParam();
  auto errors = stepErrors([&](double dt) { return worldOf(c, dt); }, c.duration, endOf(c));
  EXPECT_LE(errors.front().second, 1e-8);
  while (errors.size() > 1 && errors.back().second <= kReference) errors.pop_back();
  // The ever shorter steps in which a slip, or rolling, turns as it ends are as coarse at any dt.
  if (!c.endsTurning && errors.size() > 1) {
    EXPECT_GE(fittedOrder(errors), 3.8);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, ResistedPath, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace wells
