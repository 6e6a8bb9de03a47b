// A ball on the ground under a well: it rolls, slips and lifts off, against an independent path.
// The distance falls with the fourth power of dt, so every change is located in time.
#include <gtest/gtest.h>

#include "scenes/unit_balls.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"
#include "support/order.h"
#include "support/step_errors.h"

namespace wells {
namespace {

struct Case {
  const char* name;
  double friction;
  Vec3 well;  // m
  double strength;
  Vec3 start, velocity, spin;
  bool lifts;
  double duration;  // s
  bool slipEndsTurning = false;
};

World worldOf(const Case& c, double dt) {
  World world;
  world.settings.dt = dt;
  world.settings.elasticity = 1;
  world.settings.friction = c.friction;
  world.tracks = {{.keyframes = {{0, c.well, c.strength}}, .softening = 2}};
  addUnitBall(world, c.start, c.velocity, c.spin);
  return world;
}

/// Where it must be.
Vec3 endOf(const Case& c) {
  const World world = worldOf(c, 1);
  std::vector<oracle::SoftWell> wells{{oracle::pointOf(c.well), c.strength, 2}};
  oracle::Body body = oracle::bodiesOf(world)[0];
  const oracle::HeldUntil grounded =
      oracle::HeldBall(oracle::Support::Ground, wells, 9.81L, static_cast<double>(c.friction))
          .move(body, c.duration);
  EXPECT_EQ(grounded.lifted, c.lifts) << c.name;
  if (!grounded.lifted) return oracle::vectorOf(body.x);
  oracle::Flyer flyer{body.x, body.v};
  oracle::TaylorFlight(wells, 9.81L).fly(flyer, c.duration - grounded.time);
  return oracle::vectorOf(flyer.x);
}

const Case kCases[] = {
    // A swing of A = 0.1 m with a period of 7.44481574681213 s: a = 5/7 of the well's.
    {"rolls", 0.3, {0, 0.5, 0}, 8, {0.1, 0.5, 0}, {0, 0, 0}, {0, 0, 0}, false, 10},
    {"rolls_around", 0.5, {0, 2, 0}, 60, {4, 0.5, 1}, {0, 0, 1}, {2, 0, 0}, false, 5},
    {"rolls_then_slips", 0.1, {0, 0.5, 0}, 60, {6, 0.5, 0}, {0, 0, 0}, {0, 0, 0}, false, 3},
    {"slips_then_rolls", 0.3, {0, 2, 0}, 60, {6, 0.5, 0}, {-3, 0, 0}, {0, 3, 10}, false, 3},
    {"slides_smoothly", 0, {0, 2, 0}, 60, {4, 0.5, 1}, {0, 0, 1}, {2, 0, 0}, false, 5},
    {"slips_then_lifts_off", 0.3, {0, 4, 0}, 400, {6, 0.5, 0}, {2, 0, 0}, {0, 0, 4}, true, 1.5},
    {"slips_hardly_then_lifts_off",
     0.3,
     {0, 3, 0},
     148,
     {2, 0.5, 0},
     {-8, 0, 0},
     {0, 0, 15.94},
     true,
     0.2},
    {"smoothly_lifts_off", 0, {0, 4, 0}, 400, {6, 0.5, 1}, {-2, 0, 0}, {0, 0, 4}, true, 1.5},
    {"slip_turns_and_lasts", 0.1, {0, 2, 0}, 60, {4, 0.5, 1}, {-2, 0, 2}, {5, 3, 20}, false, 2},
    // A slip across the pull turns towards it ever faster as it ends; one that begins follows it.
    {"slip_turns", 0.3, {0, 2, 0}, 60, {4, 0.5, 1}, {-2, 0, 2}, {0, 3, 10}, false, 3, true},
    {"rolls_then_lifts_off", 0.9, {0, 4, 0}, 400, {7, 0.5, 1}, {0, 0, 0}, {0, 0, 0}, true, 1.5},
};

class GroundPath : public testing::TestWithParam<Case> {};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

// At dt = 1/60: (omega dt)^4 with omega^2 = S / softening^3 = 50 / s^2 at most is 2e-4; of a path
// of 10 m, with RK4's 1/120, 1.6e-5 m.
TEST_P(GroundPath, IsFollowed) {
  const Case& c = GetParam();
  const auto errors = stepErrors([&](double dt) { return worldOf(c, dt); }, c.duration, endOf(c));
  // The ever shorter steps in which a slip turns as it ends are as coarse at any dt: 1e-11 m.
  EXPECT_GE(fittedOrder(errors), c.slipEndsTurning ? 2.8 : 3.8);
  EXPECT_LE(errors.front().second, 1.6e-5);
}

INSTANTIATE_TEST_SUITE_P(Cases, GroundPath, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace wells
