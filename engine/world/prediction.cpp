#include "world/prediction.h"

#include "world/advance.h"

namespace wells {
namespace {

/// One ball, alone with ground and wall.
void advanceAlone(const World& world, const Field& field, const Integrator& integrator,
                  StepPlan& plan, Balls& ball) {
  plan.arenaContacts.clear();
  plan.free.clear();
  plan.touching.clear();
  const double reach = reachOf(field, ball.state(0), ball.radius[0], world.settings.dt);
  for (const std::uint32_t partner : {kWall, kGround})
    if (mayTouchArena(world.arena, ball.position[0], ball.radius[0], reach, partner))
      plan.arenaContacts.push_back({.a = 0, .b = partner});
  (plan.arenaContacts.empty() ? plan.free : plan.touching).push_back(0);
  advance(world.settings, world.arena, field, integrator, plan, ball);
}

}  // namespace

BallState predict(const World& world, std::size_t ball, const BallState& state, std::int64_t from,
                  std::int64_t to) {
  Balls alone;
  alone.add(state, world.balls.radius[ball], world.balls.mass[ball]);
  const Integrator& integrator = findIntegrator(world.settings.integrator);
  StepPlan plan;
  Field field;
  for (std::int64_t step = from; step < to; ++step) {
    updateField(world, step, field);
    advanceAlone(world, field, integrator, plan, alone);
  }
  return alone.state(0);
}

}  // namespace wells
