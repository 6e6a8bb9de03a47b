// One impact: when two balls meet, when one meets ground or wall, and what the impulse is.
#include "contacts/impacts.h"

#include <benchmark/benchmark.h>

#include "bench/micro/worlds.h"
#include "contacts/impact_time.h"

namespace wells {
namespace {

/// Two balls that meet in the midst of a step, near a wall.
World meeting(bool hasWells) {
  World world = heap(25);
  if (!hasWells) world.tracks.clear();
  world.balls = {};
  const double speed = 10;  // m/s
  const double apart = 1 + speed * world.settings.dt;
  world.balls.add({{0, 5, 0}, {speed, 0, 0}, {0, 0, 3}}, 0.5, 1);
  world.balls.add({{apart, 5.2, 0}, {-speed, 0, 0}}, 0.5, 1);
  return world;
}

void findEncounterOfBalls(benchmark::State& state) {
  const World world = meeting(state.range(0) != 0);
  const Model model(world);
  const Path a = pathFrom(model.path, world.balls.state(0), world.balls.radius[0], 0);
  const Path b = pathFrom(model.path, world.balls.state(1), world.balls.radius[1], 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(encounterOfBalls(model.path, a, b, 0, world.settings.dt));
}
BENCHMARK(findEncounterOfBalls)->ArgName("wells")->Arg(0)->Arg(1);

void findEncounterWithArena(benchmark::State& state, std::uint32_t partner) {
  World world = meeting(true);
  const double near = 0.6;  // m, of the centre: reached within the step
  BallState ball{{0, near, 0}, {0, -10, 0}, {1, 2, 3}};
  if (partner == kWall) ball = {{world.arena.radius - near, 5, 0}, {10, 0, 0}, {1, 2, 3}};
  const Model model(world);
  const Path path = pathFrom(model.path, ball, 0.5, 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(encounterWithArena(model.path, path, partner, 0, world.settings.dt));
}
BENCHMARK_CAPTURE(findEncounterWithArena, ground, kGround);
BENCHMARK_CAPTURE(findEncounterWithArena, wall, kWall);

void resolveOneImpact(benchmark::State& state) {
  const World world = meeting(false);
  Contact contact{.a = 0, .b = 1};
  touchBalls(world.balls, contact);
  contact.inverseMassA = contact.inverseMassB = 1;
  Balls balls = world.balls;
  for (auto _ : state) {
    balls.velocity = world.balls.velocity;
    balls.spin = world.balls.spin;
    benchmark::DoNotOptimize(
        resolveImpacts(world.settings.elasticity, world.settings.friction, {&contact, 1}, balls));
  }
}
BENCHMARK(resolveOneImpact);

}  // namespace
}  // namespace wells
