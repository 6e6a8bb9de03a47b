#include "bench/micro/worlds.h"

#include <map>
#include <numeric>
#include <utility>

#include "scenes/catalogue.h"
#include "world/advance.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr int kSteps = 60;

const World& afterSteps(const char* scene, std::size_t balls) {
  static std::map<std::pair<std::string, std::size_t>, World> made;
  const auto [place, isNew] = made.try_emplace({scene, balls});
  World& world = place->second;
  if (!isNew) return world;
  world = makeScene(findScene(scene), balls);
  world.settings.sleepSpeed = 0;
  const auto stepper = makeSimulation();
  for (int step = 0; step < kSteps; ++step) stepper->step(world);
  return world;
}

}  // namespace

const World& heap(std::size_t balls) {
  return afterSteps("T1", balls);
}

const World& gas(std::size_t balls) {
  return afterSteps("T2", balls);
}

StepStart::StepStart(const World& world) : balls(world.balls.size()) {
  const Field field = fieldOf(world);
  for (std::size_t i = 0; i < balls.size(); ++i)
    reach.push_back(reachOf(field, world.balls.state(i), world.balls.radius[i], world.settings.dt));
  std::iota(balls.begin(), balls.end(), 0u);
}

Model::Model(const World& world)
    : field(fieldOf(world)),
      path{.field = &field,
           .integrator = &findIntegrator(world.settings.integrator),
           .arena = &world.arena,
           .drag = world.settings.drag,
           .friction = world.settings.friction,
           .rollingResistance = world.settings.rollingResistance} {}

World afterStep(World world) {
  makeSimulation()->step(world);
  return world;
}

}  // namespace wells
