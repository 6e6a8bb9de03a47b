// The engines against an independent oracle, and so against each other: ours, the custom integrator
// of the report in its variants, and stock Bullet. Compiled twice, because Bullet's two builds
// cannot share an executable: once with ours and the reference engines, once with Bullet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/engines.h"
#include "math/random.h"
#include "scenes/catalogue.h"
#include "support/flight_oracle.h"
#include "world/measures.h"

namespace wells {
namespace {

/// What the derivations below need to know of an engine.
struct Traits {
  std::string name;
  int order = 1;           // in free flight
  double errorFactor = 1;  // local error, in units of h^2/2 max(|a|, |jerk|)
  double timeFactor = 1;   // physical time that passes per dt
  double rounding = 1e-9;  // m, m/s
  bool losesEnergy = true;
  double pushOut = 0;  // share of an overlap that becomes separating speed within a step

  /// How much too fast (m/s) two bodies that closed at `closing` may separate. Only Bullet pushes
  /// overlaps out through velocities (Baumgarte): 0.2 of the overlap a step, as long as the overlap
  /// is below 0.04 m (m_splitImpulsePenetrationThreshold), and the overlap is at most closing * h.
  double excessSpeed(double closing, double h) const {
    return pushOut * std::min(closing, 0.04 / h) + rounding;
  }
};

void PrintTo(const Traits& engine, std::ostream* out) {
  *out << engine.name;
}

std::vector<Traits> enginesHere() {
  std::vector<Traits> engines = {
      {"ours", 2},
      {"reference-euler"},
      // (v + v_last)/2 lags by half a step: once more what Euler neglects.
      {"reference-improved-euler", 1, 2},
      // As published it moves the ball by three steps a step, and gains energy in free fall (see
      // engine/reference).
      {.name = "reference-rk", .timeFactor = 3, .losesEnergy = false},
      {"reference-heun", 2},
      {"reference-rk4", 2},
      {.name = "bullet", .rounding = 2e-4, .pushOut = 0.2},  // single precision
  };
  std::erase_if(engines, [](const Traits& engine) { return !hasEngine(engine.name); });
  return engines;
}

class EachEngine : public testing::TestWithParam<Traits> {
 protected:
  const Traits& engine() const { return GetParam(); }
};

oracle::V toOracle(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 fromOracle(const oracle::V& v) {
  return {v.x, v.y, v.z};
}

World worldWithWells(oracle::Forces& forces) {
  World world;
  world.settings.friction = 0.3;
  forces.wells = {{{20, 1, 0}, 3000, 2}, {{-10, 1, 15}, -500, 2}};
  for (const oracle::PointMass& well : forces.wells)
    world.tracks.push_back(
        {.keyframes = {{0, fromOracle(well.center), well.strength}}, .softening = well.softening});
  Random random(4);
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      world.balls.add({.position = {6.0 * i, random.uniform(6, 12), 6.0 * j},
                       .velocity = 2 * random.direction()},
                      0.5, random.uniform(0.5, 2));
  return world;
}

// One-step methods: |error(t)| <= (C h^p) (e^{K t} - 1) / K, K the Lipschitz constant of
// (x, v)' = (v, a(x)), that is max(1, steepness). For order 1 a step neglects h^2/2 (a, jerk), so
// C = max(|a|, |jerk|) / 2; for order 2 it neglects h^3 times third derivatives (jerk, snap) with a
// coefficient below 1/4.
struct TruncationBound {
  double acceleration = 0, jerk = 0, snap = 0, steepness = 1;

  double at(double t, double h, const Traits& engine) const {
    const double growth = (std::exp(steepness * t) - 1) / steepness;
    const double first = engine.errorFactor * h / 2 * std::max(acceleration, jerk);
    const double second = h * h / 4 * std::max(jerk, snap);
    return (engine.order == 1 ? first : second) * growth + engine.rounding;
  }
};

/// True when the ball may touch ground, wall or another ball soon: within 0.3 m.
bool mayTouch(const std::vector<oracle::Ball>& balls, std::size_t i) {
  const oracle::V& x = balls[i].x;
  if (x.y < 0.8 || std::hypot(x.x, x.z) > 39.2) return true;
  for (std::size_t j = 0; j < balls.size(); ++j)
    if (j != i && oracle::norm(balls[j].x - x) < 1.3) return true;
  return false;
}

TEST_P(EachEngine, FollowsTheTrueFlightUntilTheFirstImpact) {
  for (const double dt : {1.0 / 60, 1.0 / 240}) {
    oracle::Forces forces;
    World world = worldWithWells(forces);
    world.settings.dt = dt;
    const auto stepper = makeEngine(engine().name);
    std::vector<oracle::Ball> truth;
    for (std::size_t i = 0; i < world.balls.size(); ++i)
      truth.push_back({toOracle(world.balls.position[i]), toOracle(world.balls.velocity[i])});
    std::vector<TruncationBound> bounds(truth.size());
    std::vector<bool> flies(truth.size(), true);

    const double h = dt * engine().timeFactor;
    int compared = 0;
    for (int step = 1; step * h <= 1.5; ++step) {
      stepper->step(world);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const oracle::V before = forces.acceleration(truth[i].x);
        truth[i] = oracle::fly(forces, truth[i], h);
        const oracle::V after = forces.acceleration(truth[i].x);
        TruncationBound& bound = bounds[i];
        const double speed = oracle::norm(truth[i].v);
        const double steep = forces.steepness(truth[i].x);
        bound.acceleration = std::max(bound.acceleration, oracle::norm(after));
        bound.jerk = std::max(bound.jerk, oracle::norm(after - before) / h);
        // |snap| <= |da/dx| |a| + |d2a/dx2| |v|^2, the latter below 3 steepness / distance of 5 m.
        bound.snap =
            std::max(bound.snap, steep * oracle::norm(after) + 3 * steep / 5 * speed * speed);
        bound.steepness = std::max(bound.steepness, steep);
      }
      for (std::size_t i = 0; i < truth.size(); ++i) {
        flies[i] = flies[i] && !mayTouch(truth, i);
        if (!flies[i]) continue;
        ++compared;
        const double allowed = bounds[i].at(step * h, h, engine());
        EXPECT_LE(length(world.balls.position[i] - fromOracle(truth[i].x)), allowed)
            << "ball " << i << " at " << step * h << " s, dt " << dt;
      }
    }
    EXPECT_GT(compared, 25 * 0.6 / h);  // most balls, most of the time
  }
}

// Dropped from height d with restitution e: hits after t1 = sqrt(2 d / g) with v = g t1 and is at
// e v s - g s^2 / 2 above the ground s later. A first-order method is late by up to a step (which
// costs (1 + e) v h in position), and its speed at the hit is off by up to g h, which counts e s
// long; twice that for the second step in which some engines notice.
TEST_P(EachEngine, BouncesOnceWithinTheFirstOrderBound) {
  const double e = 0.8, g = 9.81, drop = 2;
  const double impactTime = std::sqrt(2 * drop / g);
  const double impactSpeed = g * impactTime;
  const double end = impactTime + 0.6 * (2 * e * impactSpeed / g);
  const double s = end - impactTime;
  const double exact = 0.5 + e * impactSpeed * s - g * s * s / 2;
  for (const double dt : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
    const double h = dt * engine().timeFactor;
    World world;
    world.settings.dt = dt;
    world.settings.elasticity = e;
    world.balls.add({.position = {0, 0.5 + drop, 0}}, 0.5, 1);
    const auto stepper = makeEngine(engine().name);
    const int steps = static_cast<int>(std::floor(end / h));
    for (int i = 0; i < steps; ++i) stepper->step(world);
    const double unfinished = end - steps * h;  // s, flown exactly
    const double y = world.balls.position[0].y() + world.balls.velocity[0].y() * unfinished -
                     g * unfinished * unfinished / 2;
    const double bound =
        2 * ((1 + e) * impactSpeed * h + e * g * h * s) + engine().excessSpeed(impactSpeed, h) * s;
    EXPECT_LE(std::abs(y - exact), bound) << "dt " << dt;
  }
}

// Without forces, e = 0.8, smooth: head-on the velocities are exact, whenever the impact is
// noticed; the positions are off by up to the change of speed times a step (two, where the pair is
// noticed late).
TEST_P(EachEngine, TwoBallsMeetHeadOn) {
  const double e = 0.8, speed = 4;
  World world;
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = e;
  world.settings.friction = 0;
  world.balls.add({.position = {-2, 3, 0}, .velocity = {speed, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {0.3, 3, 0}}, 0.5, 3);
  const auto stepper = makeEngine(engine().name);
  const double h = world.settings.dt * engine().timeFactor;
  const int steps = 60;
  for (int i = 0; i < steps; ++i) stepper->step(world);
  const double after1 = speed * (1 - e * 3) / 4;
  const double after2 = speed * (1 + e) / 4;
  const double excess = engine().excessSpeed(speed, h);
  EXPECT_NEAR(world.balls.velocity[0].x(), after1, excess);
  EXPECT_NEAR(world.balls.velocity[1].x(), after2, excess);
  const double hit = (2.3 - 1) / speed;
  const double rest = steps * h - hit;
  const double late = 2 * (speed - after1) * h + excess * rest;
  EXPECT_NEAR(world.balls.position[0].x(), -2 + speed * hit + after1 * rest, late);
  EXPECT_NEAR(world.balls.position[1].x(), 0.3 + after2 * rest, late);
}

// Centres 0.4 m off the line of flight: the impact is seen up to two steps late, when the line of
// centres has turned by up to 2 v h / (2 r) / cos; the velocities turn with it.
TEST_P(EachEngine, TwoBallsMeetObliquely) {
  const double speed = 5;
  const double along = std::sqrt(1 - 0.4 * 0.4);
  World world;
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  world.balls.add({.position = {0, 3, 0}, .velocity = {speed, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {3, 3, 0.4}}, 0.5, 1);
  const auto stepper = makeEngine(engine().name);
  const double h = world.settings.dt * engine().timeFactor;
  for (int i = 0; i * h < 0.6; ++i) stepper->step(world);
  const Vec3 struck{speed * along * along, 0, speed * along * 0.4};
  const double turned = 2 * speed * h / along;  // rad; 2 r = 1 m
  EXPECT_LE(length(world.balls.velocity[1] - struck),
            2 * speed * turned + engine().excessSpeed(speed, h));
  // Momentum does not depend on when.
  EXPECT_LE(length(world.balls.velocity[0] + world.balls.velocity[1] - Vec3(speed, 0, 0)),
            engine().rounding);
}

TEST_P(EachEngine, KeepsTheTemplateWorldTogether) {
  for (const std::size_t balls : {25u, 200u}) {
    World world = makeScene(findScene("template"), balls);
    const double start = measure(world).energy();
    const auto stepper = makeEngine(engine().name);
    for (int i = 0; i < 600; ++i) stepper->step(world);
    const Measures end = measure(world);
    EXPECT_EQ(end.escaped, 0) << balls << " balls";
    EXPECT_TRUE(!engine().losesEnergy || end.energy() < start)
        << balls << " balls: " << start << " J, then " << end.energy() << " J";
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, EachEngine, testing::ValuesIn(enginesHere()),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace wells
