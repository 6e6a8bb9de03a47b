// Every answer in exact_answers.cpp, derived again: by closed forms, by the event-driven reference
// or by the power series of tests/support. Tolerances: the answers have 16 digits, and the scenes'
// starts are rounded to doubles, which impacts magnify up to tenfold.
#include "scenes/exact_answers.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "scenes/catalogue.h"
#include "support/held_ball.h"
#include "support/oracle_world.h"

namespace wells {
namespace {

constexpr double kDigits = 2e-15;  // of the largest coordinate

void expectAnswer(const char* scene, const std::vector<oracle::P>& end, double digits = kDigits) {
  const AccuracyCase& answer = findAccuracyCase(scene);
  ASSERT_EQ(answer.end.size(), end.size()) << scene;
  for (const auto& [ball, position] : answer.end) {
    const Vec3 expected = oracle::vectorOf(end.at(ball));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(position[axis], expected[axis], digits * std::max(1.0, length(expected)))
          << scene << ", ball " << ball << ", axis " << axis;
  }
}

TEST(ExactAnswers, AreOfScenesWhoseDefaultRunIsAsLong) {
  std::set<std::string_view> seen;
  for (const AccuracyCase& answer : accuracyCases()) {
    const Scene& scene = findScene(answer.scene);
    EXPECT_TRUE(seen.insert(answer.scene).second) << answer.scene << " stands twice";
    EXPECT_EQ(static_cast<double>(scene.defaultSteps), answer.duration * 60) << answer.scene;
    EXPECT_NE(scene.fixedBalls, 0u) << answer.scene;
    EXPECT_EQ(answer.end.size(), answer.error == ErrorKind::Position ? scene.fixedBalls : 0)
        << answer.scene;
    // Whole numbers of steps for dt = 1/6, 1/30, 1/60 ...
    EXPECT_EQ(answer.duration * 6, std::round(answer.duration * 6)) << answer.scene;
  }
  EXPECT_THROW(findAccuracyCase("T1"), std::invalid_argument);
}

TEST(ExactAnswers, PositionErrorIsTheLargestDistance) {
  const AccuracyCase& answer = findAccuracyCase("oblique-balls");
  World world = makeScene(findScene("oblique-balls"));
  for (const auto& [ball, position] : answer.end) world.balls.position[ball] = position;
  EXPECT_EQ(positionError(answer, world), 0);
  world.balls.position[0] += Vec3(0, 0.5, 0);
  world.balls.position[1] += Vec3(3, 0, -4);
  EXPECT_NEAR(positionError(answer, world), 5, 1e-14);
  world.balls.position[0].x() = std::nan("");
  EXPECT_TRUE(std::isinf(positionError(answer, world)));
}

TEST(ExactAnswers, ImpactsOneByOne) {
  const std::pair<const char*, std::int64_t> cases[] = {{"bounce", 5},
                                                        {"zeno", 5},
                                                        {"oblique-ground", 2},
                                                        {"oblique-balls", 1},
                                                        {"friction-balls-stick", 1},
                                                        {"friction-balls-slip", 1},
                                                        {"billiard", 2},
                                                        {"circle-billiard", 277},
                                                        {"cradle", 4},
                                                        {"galperin", 314},
                                                        {"collapse-twin", 10}};
  for (const auto& [name, hits] : cases) {
    const World world = makeScene(findScene(name));
    std::vector<oracle::Body> bodies = oracle::bodiesOf(world);
    const oracle::Hits counted =
        oracle::fly(oracle::rulesOf(world), bodies, findAccuracyCase(name).duration);
    EXPECT_EQ(counted.count, hits) << name;
    std::vector<oracle::P> end;
    for (const oracle::Body& body : bodies) end.push_back(body.x);
    expectAnswer(name, end);
  }
}

// Fallen by h = 5 m it hits after t1 = sqrt(2 h / g); the flights then last 2 t1 e, 2 t1 e^2, ...,
// all of them t1 (1 + e) / (1 - e) with the fall: 3.03 s for e = 0.5.
TEST(ExactAnswers, ZenoRests) {
  const World world = makeScene(findScene("zeno-rest"));
  const oracle::Real e = world.settings.elasticity;
  EXPECT_LT(std::sqrt(2 * 5 / 9.81L) * (1 + e) / (1 - e), findAccuracyCase("zeno-rest").duration);
  expectAnswer("zeno-rest", {{0, 0.5L, 0}});
}

// Friction mu g against the slip v0 + r w0, of which it takes 7/2 mu g a second: it slides until
// t1 = 2 (v0 + r w0) / (7 mu g) and rolls on with v0 - mu g t1.
TEST(ExactAnswers, SlidingBecomesRolling) {
  for (const char* name : {"slide-to-roll", "backspin", "backspin-return"}) {
    const World world = makeScene(findScene(name));
    const oracle::Real v0 = 5, r = 0.5L, g = 9.81L, mu = 0.3L, w0 = world.balls.spin[0].z();
    const oracle::Real t1 = 2 * (v0 + r * w0) / (7 * mu * g);
    const oracle::Real rest = findAccuracyCase(name).duration - t1;
    ASSERT_GT(rest, 0);
    expectAnswer(name,
                 {{v0 * t1 - mu * g * t1 * t1 / 2 + (5 * v0 - 2 * r * w0) / 7 * rest, 0.5L, 0}});
  }
}

// Round the wall by phi = v t / rho. With friction v' = -mu v^2 / rho until v = 5/7 v0; that is
// after t1 = 2 rho / (5 mu v0), on the way rho / mu ln(7/5).
TEST(ExactAnswers, AlongTheWall) {
  const oracle::Real rho = 9.5L, v0 = 5, mu = 0.3L;
  const auto at = [&](oracle::Real way) -> oracle::P {
    return {rho * std::cos(way / rho), 1, -rho * std::sin(way / rho)};
  };
  expectAnswer("whispering-gallery", {at(v0 * 10)});
  const oracle::Real t1 = 2 * rho / (5 * mu * v0);
  expectAnswer("wall-slide-to-roll", {at(rho / mu * std::log(1.4L) + 5 * v0 / 7 * (5 - t1))});
}

// Rolling, the spin about the normal turns with the ball: y'' = -5/7 g - 2/7 Omega^2 (y - y0).
TEST(ExactAnswers, RollingRoundTheWall) {
  const oracle::Real rho = 9.5L, omega = 4, t = 10;
  const oracle::Real fallen =
      5 * 9.81L / (2 * omega * omega) * (1 - std::cos(std::sqrt(2 / 7.0L) * omega * t));
  expectAnswer("wall-rolling",
               {{rho * std::cos(omega * t), 5 - fallen, -rho * std::sin(omega * t)}});
}

// In the corner the friction that turns the spin of a ball that rolls on the ground presses it to
// the wall, N = 7/5 v^2 / rho: v' = -mu v^2 / rho while the slip v + r w falls 9/2 times as fast;
// it is used up at v = 7/9 v0. Rolling on both, the energy is 9/10 m v^2, so drag k gives v' = -5/9
// k v.
TEST(ExactAnswers, InTheCorner) {
  const oracle::Real rho = 9.5L, v0 = 5, mu = 0.3L, t = 10;
  const auto at = [&](oracle::Real way) -> oracle::P {
    return {rho * std::cos(way / rho), 0.5L, -rho * std::sin(way / rho)};
  };
  const oracle::Real t1 = 2 * rho / (7 * mu * v0);
  expectAnswer("corner-slide-to-roll", {at(rho / mu * std::log(9 / 7.0L) + 7 * v0 / 9 * (t - t1))});
  const oracle::Real slows = -5 / 9.0L * std::log(0.9L);
  expectAnswer("corner-rolling", {at(v0 / slows * (1 - std::exp(-slows * t)))});
}

TEST(ExactAnswers, RollingUnderAWell) {
  const World world = makeScene(findScene("rolling-well"));
  oracle::Body ball = oracle::bodiesOf(world)[0];
  oracle::HeldBall(oracle::Support::Ground, {{{0, 0.5L, 0}, 8, 2}}, 9.81L, 0.3L).move(ball, 10);
  expectAnswer("rolling-well", {ball.x}, 1e-13);
}

// With beta = b/r: while it slides v' = -mu g and the slip's rate is (5/2 beta - 7/2 mu) g;
// rolling, v' = -5/7 beta g.
TEST(ExactAnswers, RollingStops) {
  const oracle::Real g = 9.81L, mu = 0.3L, beta = 0.1L / 0.5L, v0 = 5;
  const oracle::Real t1 = v0 / ((3.5L * mu - 2.5L * beta) * g), v1 = v0 - mu * g * t1;
  const oracle::Real braking = 5 * beta * g / 7;
  EXPECT_LT(t1 + v1 / braking, findAccuracyCase("rolling-stops").duration);
  expectAnswer("rolling-stops", {{(v0 + v1) / 2 * t1 + v1 * v1 / (2 * braking), 0.5L, 0}});
}

// From one turning point to the next the well's work S/sqrt(x^2 + 4) goes into beta g times the
// way; it rests at the first where the pull is no more than beta g. The swings last less than 4 s
// each.
TEST(ExactAnswers, StuckUnderAWell) {
  const oracle::Real hold = 9.81L * 0.01L / 0.5L;
  const auto work = [](oracle::Real x) { return 8 / std::sqrt(x * x + 4); };
  oracle::Real x = 1;
  int swings = 0;
  for (; 8 * std::abs(x) / std::pow(x * x + 4, 1.5L) > hold; ++swings) {
    const oracle::Real side = x > 0 ? -1 : 1;
    oracle::Real low = 1e-3L, high = 3;  // m, of the way
    for (int i = 0; i < 200; ++i) {
      const oracle::Real way = (low + high) / 2;
      (work(x + side * way) - work(x) > hold * way ? low : high) = way;
    }
    x += side * low;
  }
  EXPECT_EQ(swings, 2);
  expectAnswer("stuck-under-a-well", {{x, 0.5L, 0}});
}

// e = 0.05 < 7 - 4 sqrt(3): the middle of three closes on both others for ever faster impacts. The
// sum of momenta is shared: v = 1/3 each; the centre of mass has moved on by t / 3 from 5.5 / 3,
// and they stay 1 m apart.
TEST(ExactAnswers, CollapseMovesAsOne) {
  const oracle::Real middle = (5.5L + 6) / 3;
  expectAnswer("collapse", {{middle - 1, 1, 0}, {middle, 1, 0}, {middle + 1, 1, 0}});
}

/// A tetrahedral pile that falls without leaning, by the angle a between the vertical and the lines
/// from the lower centres to the upper: R = sin a from the axis, h = cos a above. With N and mu N
/// at the upper contacts, and the lower balls rolling,
///   7/5 R'' = N (sin a - mu (1 + cos a)),  h'' = -g + 3 N (cos a + mu sin a).
struct FallingPile {
  oracle::Real g, mu;

  struct State {
    oracle::Real a, w;
  };

  oracle::Real acceleration(const State& now) const {
    const oracle::Real s = std::sin(now.a), c = std::cos(now.a);
    const oracle::Real k = 21 / 5.0L * (c + mu * s) / (s - mu * (1 + c));
    return (g - c * now.w * now.w + k * s * now.w * now.w) / (s + k * c);
  }

  /// By the classical Runge-Kutta method in n steps.
  State after(oracle::Real duration, State now, int n) const {
    const oracle::Real h = duration / n;
    const auto slope = [&](const State& x) { return State{x.w, acceleration(x)}; };
    const auto on = [](const State& x, oracle::Real t, const State& d) {
      return State{x.a + t * d.a, x.w + t * d.w};
    };
    for (int i = 0; i < n; ++i) {
      const State k1 = slope(now), k2 = slope(on(now, h / 2, k1)), k3 = slope(on(now, h / 2, k2)),
                  k4 = slope(on(now, h, k3));
      now = on(now, h / 6, {k1.a + 2 * k2.a + 2 * k3.a + k4.a, k1.w + 2 * k2.w + 2 * k3.w + k4.w});
    }
    return now;
  }
};

TEST(ExactAnswers, APileThatSlips) {
  const oracle::Real sine60 = std::sqrt(3.0L) / 2;
  const FallingPile pile{9.81L, 0.3L};
  const oracle::Real start = std::asin((1 + 1e-6L) / std::sqrt(3.0L));
  EXPECT_NEAR(static_cast<double>(pile.acceleration({start, 0}) * std::cos(start)), 0.0760485,
              2e-6);
  const oracle::Real a = pile.after(findAccuracyCase("pile-slips").duration, {start, 0}, 2000).a;
  const oracle::Real r = std::sin(a);
  expectAnswer("pile-slips", {{r, 0.5L, 0},
                              {-r / 2, 0.5L, sine60 * r},
                              {-r / 2, 0.5L, -sine60 * r},
                              {0, 0.5L + std::cos(a), 0}});
}

TEST(ExactAnswers, AColumnStands) {
  std::vector<oracle::P> end;
  for (int k = 0; k < 10; ++k) end.push_back({0, 0.5L + k, 0});
  expectAnswer("column", end);
}

// 338 impacts: a ball moved by 1e-15 m would change the energy by 1e-12.
TEST(ExactAnswers, AGasThatCools) {
  const World world = makeScene(findScene("cooling-gas"));
  const AccuracyCase& answer = findAccuracyCase("cooling-gas");
  std::vector<oracle::Body> bodies = oracle::bodiesOf(world);
  const oracle::Hits hits = oracle::fly(oracle::rulesOf(world), bodies, answer.duration);
  oracle::Real energy = 0;
  for (const oracle::Body& body : bodies) energy += body.m / 2 * oracle::inner(body.v, body.v);
  EXPECT_EQ(hits.count, 338);
  EXPECT_NEAR(answer.endEnergy / static_cast<double>(energy), 1, 1e-14) << hits.count;
}

TEST(ExactAnswers, PathsAboutWells) {
  for (const char* name : {"orbit", "orbit-short", "circular-orbit", "through-the-centre",
                           "well-bounces", "well-bounces-long"}) {
    const World world = makeScene(findScene(name));
    oracle::Flyer ball{oracle::pointOf(world.balls.position[0]),
                       oracle::pointOf(world.balls.velocity[0])};
    oracle::flightOf(world).fly(ball, findAccuracyCase(name).duration);
    expectAnswer(name, {ball.x});
  }
}

// A circle of radius 10 m is travelled at angular speed sqrt(S / (r^2 + softening^2)^(3/2)).
TEST(ExactAnswers, CircularOrbitIsACircle) {
  const oracle::Real w = std::sqrt(1000 / std::pow(104.0L, 1.5L));
  expectAnswer("circular-orbit", {{10 * std::cos(20 * w), 20, 10 * std::sin(20 * w)}});
}

}  // namespace
}  // namespace wells
