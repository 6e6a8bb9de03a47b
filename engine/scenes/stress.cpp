#include "scenes/stress.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "math/random.h"
#include "scenes/crowds.h"
#include "scenes/own_well.h"
#include "scenes/scatter.h"

namespace wells {
namespace {

constexpr double kRadius = 0.5;  // m
constexpr double kMass = 1;      // kg
constexpr double kFast = 1e4;    // m/s
constexpr double kStandardGravity = 9.81;

void addBall(World& world, const Vec3& position, const Vec3& velocity = Vec3::Zero(),
             double radius = kRadius, double mass = kMass) {
  world.balls.add({.position = position, .velocity = velocity}, radius, mass);
}

World worldOf(double elasticity, double friction) {
  World world;
  world.settings.elasticity = elasticity;
  world.settings.friction = friction;
  return world;
}

World weightlessWorld(double elasticity, double friction) {
  World world = worldOf(elasticity, friction);
  world.settings.gravity = Vec3::Zero();
  return world;
}

struct FastWorld {
  StressWorld made;
  bool isOblique;
};

FastWorld fastWorld(int version) {
  const bool isOblique = (version & 1) != 0;
  const double elasticity = (version & 2) != 0 ? 0.5 : 1;
  const double friction = (version & 4) != 0 ? 0.3 : 0;
  World world = worldOf(elasticity, friction);
  world.settings.dt = 0.1;
  return {{.about = fmt::format("{}, e = {}, mu = {}", isOblique ? "oblique" : "straight",
                                elasticity, friction),
           .world = std::move(world)},
          isOblique};
}

/// 25 balls just above the ground with up to 5 m/s, where nothing but gravity pulls.
World movingBalls() {
  World world;
  world.arena.radius = 10;
  scatterBalls(world, 25, kRadius, kMass, 1);
  Random random(2);
  for (Vec3& velocity : world.balls.velocity) {
    velocity = random.direction();  // before the speed: the order of the draws is the world's
    velocity *= random.uniform(0, 5);
  }
  return world;
}

}  // namespace

StressWorld makeFastAtWall(int version) {
  auto [made, isOblique] = fastWorld(version);
  addBall(made.world, {0, 3, isOblique ? 20.0 : 0.0}, {kFast, 0, 0});
  return made;
}

StressWorld makeFastAtGround(int version) {
  auto [made, isOblique] = fastWorld(version);
  // Oblique is flat, so that the ball stays below the top of walls that have one.
  constexpr double kDown = 20;  // m/s
  addBall(
      made.world, {0, 3, 0},
      isOblique ? Vec3{std::sqrt(kFast * kFast - kDown * kDown), -kDown, 0} : Vec3{0, -kFast, 0});
  return made;
}

StressWorld makeFastAtBall(int version) {
  auto [made, isOblique] = fastWorld(version);
  addBall(made.world, {-20, 3, 0}, {kFast, 0, 0});
  addBall(made.world, {0, 3, isOblique ? kRadius : 0});
  return made;
}

StressWorld makeCoarseHeaps(double dt) {
  StressWorld made{.about = "", .world = makeWellsCrowd(1000, 1)};
  made.world.settings.dt = dt;
  return made;
}

StressWorld makeOverlappingPair(int version) {
  struct Pair {
    std::string_view about;
    double distance, speed, radius, mass, elasticity;
  };
  constexpr std::array kPairs = {
      Pair{"half overlapped", 0.5, 0, kRadius, kMass, 0.8},
      Pair{"in one point", 0, 0, kRadius, kMass, 0.8},
      Pair{"half overlapped, closing at 2 m/s", 0.5, 2, kRadius, kMass, 0.8},
      Pair{"in one point, passing at 2 m/s", 0, 2, kRadius, kMass, 0.8},
      Pair{"in one point, e = 1", 0, 0, kRadius, kMass, 1},
      Pair{"the other of 0.1 m and 1 g inside the first", 0.2, 0, 0.1, 1e-3, 0.8},
  };
  const Pair& pair = kPairs.at(static_cast<std::size_t>(version));
  World world = weightlessWorld(pair.elasticity, 0.3);
  addBall(world, {0, 5, 0}, {pair.speed, 0, 0});
  addBall(world, {pair.distance, 5, 0}, Vec3::Zero(), pair.radius, pair.mass);
  return {.about = std::string(pair.about), .world = std::move(world)};
}

StressWorld makeOverlappingClump(int version) {
  struct Clump {
    std::string_view about;
    double spacing, elasticity;
    bool onGround;
  };
  constexpr std::array kClumps = {Clump{"in one point", 0, 0.8, false},
                                  Clump{"in one point, e = 1", 0, 1, false},
                                  Clump{"on a lattice of 0.5 m", 0.5, 0.8, false},
                                  Clump{"in one point on the ground, gravity", 0, 0.8, true}};
  const Clump& clump = kClumps.at(static_cast<std::size_t>(version));
  World world =
      clump.onGround ? worldOf(clump.elasticity, 0.3) : weightlessWorld(clump.elasticity, 0.3);
  const Vec3 corner{0, clump.onGround ? kRadius : 5, 0};
  for (int i = 0; i < 27; ++i)
    addBall(world, corner + clump.spacing * Vec3{i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0});
  // They may be pushed apart into any heap; a tower is the highest.
  constexpr double kMeanLift = 13;  // m
  return {.about = std::string(clump.about),
          .world = std::move(world),
          .pushOut = clump.onGround ? 27 * kMass * kStandardGravity * kMeanLift : 0};
}

StressWorld makeInsideArena(int version) {
  struct Place {
    std::string_view about;
    double intoWall, intoGround;  // m, by which the ball is beyond touching
  };
  constexpr std::array kPlaces = {
      Place{"half in the ground", 0, 0.5},
      Place{"wholly in the ground", 0, 1},
      Place{"half in the wall", 0.5, -1},
      Place{"wholly in the wall", 1, -1},
      Place{"half in the corner of both", 0.5, 0.5},
      Place{"wholly in the corner of both", 1, 1},
  };
  const Place& place = kPlaces.at(static_cast<std::size_t>(version));
  World world;
  const double toWall = world.arena.radius - kRadius;
  addBall(world,
          {place.intoWall > 0 ? toWall + place.intoWall : 0.0, kRadius - place.intoGround, 0});
  return {.about = std::string(place.about),
          .world = std::move(world),
          .pushOut = kMass * kStandardGravity * std::max(place.intoGround, 0.0)};
}

StressWorld makeSharpWell(int version) {
  struct Fall {
    std::string_view about;
    double aside;  // m
    bool isPair;
    double elasticity;
  };
  constexpr std::array kFalls = {Fall{"one ball head-on", 0, false, 0.8},
                                 Fall{"one ball, 1 cm aside", 0.01, false, 0.8},
                                 Fall{"two balls from both sides, e = 1", 0, true, 1},
                                 Fall{"two balls from both sides, e = 0.8", 0, true, 0.8}};
  const Fall& fall = kFalls.at(static_cast<std::size_t>(version));
  World world = weightlessWorld(fall.elasticity, 0.3);
  const Vec3 well{0, 20, 0};
  world.tracks.push_back({.keyframes = {{0, well, 100}}, .softening = 0.01});
  addBall(world, well + Vec3{10, fall.aside, 0});
  if (fall.isPair) addBall(world, well - Vec3{10, 0, 0});
  return {.about = std::string(fall.about), .world = std::move(world)};
}

StressWorld makeCollapsingGas(int version) {
  World world = makeGas(1000, 1);
  world.settings.elasticity = 0.05;
  world.settings.friction = version == 0 ? 0 : 0.3;
  return {.about = fmt::format("mu = {}", world.settings.friction), .world = std::move(world)};
}

StressWorld makeMassRatio(int version) {
  struct Stack {
    std::string_view about;
    std::array<double, 3> masses;  // kg, from below; 0: none
  };
  constexpr std::array kStacks = {Stack{"10^6 kg on 1 kg", {1, 1e6, 0}},
                                  Stack{"10^6 kg on 10^3 kg on 1 kg", {1, 1e3, 1e6}},
                                  Stack{"1 kg on 10^6 kg", {1e6, 1, 0}}};
  const Stack& stack = kStacks.at(static_cast<std::size_t>(version));
  World world = worldOf(0.5, 0.3);
  double height = kRadius;
  for (const double mass : stack.masses) {
    if (mass == 0) continue;
    addBall(world, {0, height, 0}, Vec3::Zero(), kRadius, mass);
    height += 2 * kRadius;
  }
  return {.about = std::string(stack.about), .world = std::move(world)};
}

StressWorld makeRadiusRatio() {
  World world = worldOf(0.5, 0.3);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      addBall(world, {0.2 * i, 0.05, 0.2 * j}, Vec3::Zero(), 0.05, 1e-3);
  addBall(world, {0, 6, 0}, Vec3::Zero(), 5, 1e3);
  return {.about = "", .world = std::move(world)};
}

StressWorld makeOddWells(int version) {
  StressWorld made;
  World& world = made.world;
  scatterBalls(world, 25, kRadius, kMass, 1);
  const double strength = defaultWellStrength(world.arena, 2);
  const Vec3 middle{0, 1, 0};
  if (version == 0) {
    made.about = "two wells at one point";
    for (int i = 0; i < 2; ++i) world.tracks.push_back({.keyframes = {{0, middle, strength}}});
  } else if (version == 1) {
    made.about = "a well that jumps";
    const Vec3 left{-50, 1, 0};
    const Vec3 right{50, 1, 0};
    world.tracks.push_back({.keyframes = {{120, left, strength},
                                          {121, right, strength},
                                          {180, right, strength},
                                          {181, left, strength}}});
  } else {
    made.about = "a well that repels";
    world.tracks.push_back({.keyframes = {{0, middle, -strength}}});
  }
  return made;
}

StressWorld makeTouchingLattice(int version) {
  World world = weightlessWorld(1, 0);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) addBall(world, {1.0 * i, 1, 1.0 * j});
  addBall(world, {-5, 1, version == 0 ? 4.0 : 4.5}, {10, 0, 0});
  return {.about = version == 0 ? "hit head-on to a row" : "hit between two rows",
          .world = std::move(world)};
}

StressWorld makeCornerSpin(int version) {
  constexpr std::array<std::string_view, 3> kAxes = {"the wall's normal", "upwards",
                                                     "along the wall"};
  const double friction = version < 3 ? 0.3 : 1;
  const int axis = version % 3;
  World world = worldOf(0.5, friction);
  addBall(world, {world.arena.radius - kRadius, kRadius, 0});
  world.balls.spin[0][axis] = 100;  // rad/s
  return {.about = fmt::format("spin about {}, mu = {}", kAxes.at(static_cast<std::size_t>(axis)),
                               friction),
          .world = std::move(world)};
}

StressWorld makeFarAway() {
  World world = movingBalls();
  world.arena.center = {1e6, 0, -1e6};
  for (Vec3& position : world.balls.position) position += world.arena.center;
  return {.about = "", .world = std::move(world)};
}

StressWorld makeAnyStep(int version) {
  constexpr std::array kSteps = {1e-6, 1e-4, 1e-2, 0.1, 1.0};  // s
  World world = movingBalls();
  world.settings.dt = kSteps.at(static_cast<std::size_t>(version));
  return {.about = fmt::format("dt = {} s", world.settings.dt), .world = std::move(world)};
}

StressWorld makeNotFinite(int version) {
  constexpr std::array<std::string_view, 3> kWhere = {"position", "velocity", "spin"};
  const bool isNan = version < 3;
  const int where = version % 3;
  World world = movingBalls();
  BallState bad{.position = {0, 3, 0}};
  Vec3& wrong = where == 0 ? bad.position : where == 1 ? bad.velocity : bad.spin;
  wrong.x() =
      isNan ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
  world.balls.add(bad, kRadius, kMass);
  return {.about = fmt::format("{} in the {}", isNan ? "NaN" : "infinity",
                               kWhere.at(static_cast<std::size_t>(where))),
          .world = std::move(world),
          .bad = 1};
}

}  // namespace wells
