// Flight of all balls through a step, by integrator, under four wells.
#include <benchmark/benchmark.h>

#include "bench/micro/worlds.h"
#include "flight/integrators.h"

namespace wells {
namespace {

void fly(benchmark::State& state, const Integrator* integrator) {
  const World& world = heap(10000);
  const Model model(world);
  const StepStart start(world);
  Balls balls = world.balls;
  // Forwards and back: the balls stay where they are.
  double duration = world.settings.dt;
  for (auto _ : state) {
    flyThrough(*integrator, {&model.field, 0, duration, 1}, start.balls, balls.position.data(),
               balls.velocity.data());
    for (Vec3& velocity : balls.velocity) velocity = -velocity;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(balls.size()));
}

[[maybe_unused]] const bool areRegistered = [] {
  for (const Integrator& integrator : integrators())
    benchmark::RegisterBenchmark(("fly/" + std::string(integrator.name)).c_str(), fly, &integrator);
  return true;
}();

}  // namespace
}  // namespace wells
