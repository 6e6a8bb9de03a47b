#include "world/advance.h"

namespace wells {
namespace {

// Waking a thread takes as long as the flight of some thousand balls.
constexpr std::size_t kLeastFlight = 8192;

}  // namespace

double pullOf(const Field& field, const Vec3& position, double dt) {
  return length(acceleration(field, position, 0)) * dt;
}

double reachOf(const Field& field, const BallState& ball, double radius, double dt) {
  const double speed = length(ball.velocity);
  return (speed + pullOf(field, ball.position, dt)) * dt + kReachMargin * radius;
}

void enlargeReach(const Vec3& start, const BallState& now, double dt, double& reach) {
  reach = 2 * (length(now.position - start) + length(now.velocity) * dt);
}

bool mayTouchArena(const Arena& arena, const Vec3& position, double radius, double reach,
                   std::uint32_t partner) {
  const double gap =
      partner == kGround ? groundGap(arena, position, radius) : wallGap(arena, position, radius);
  return gap <= reach;
}

bool hasMissedArena(const Arena& arena, const Vec3& start, const Vec3& now, double radius,
                    double reach) {
  const auto hasMissed = [&](std::uint32_t partner) {
    return !mayTouchArena(arena, start, radius, reach, partner) &&
           mayTouchArena(arena, now, radius, 0, partner);
  };
  return hasMissed(kGround) || hasMissed(kWall);
}

ResolvedCounts advance(const Settings& settings, const PathModel& model, StepPlan& plan,
                       Balls& balls, ThreadPool& pool, Books* books) {
  StageScope stage(plan.workspace.clock, Stage::Flight);
  Vec3* const position = balls.position.data();
  Vec3* const velocity = balls.velocity.data();
  const Ledger ledger{books, model.arena->center};
  const auto fly = [&](double start, double duration, const std::vector<std::uint32_t>& list) {
    if (ledger)
      for (const std::uint32_t i : list)
        bookPath(ledger, model, {balls.state(i), start, balls.radius[i]}, balls.mass[i],
                 start + duration);
    const Flight flight{model.field, start, duration, model.drag};
    pool.forRanges(list.size(), kLeastFlight, [&](std::size_t begin, std::size_t end, std::size_t) {
      flyThrough(*model.integrator, flight, std::span(list).subspan(begin, end - begin), position,
                 velocity);
    });
  };
  fly(0, settings.dt, plan.free);

  const double h = settings.dt / settings.substeps;
  plan.velocityBefore.resize(balls.size());
  ResolvedCounts counts;
  const bool anyInSubsteps = !plan.touching.empty() || !plan.drifting.empty();
  for (int substep = 0; anyInSubsteps && substep < settings.substeps; ++substep) {
    for (const std::uint32_t i : plan.touching) plan.velocityBefore[i] = velocity[i];
    for (const std::uint32_t i : plan.drifting) {
      plan.velocityBefore[i] = velocity[i];
      position[i] += velocity[i] * h;
    }
    fly(substep * h, h, plan.touching);
    const SubstepBooks booking{books, model.field, (substep + 1) * h, plan.touching};
    const ResolvedCounts resolved = resolveContacts(
        settings, *model.arena, h, {plan.ballContacts, plan.arenaContacts},
        plan.velocityBefore.data(), balls, plan.workspace, books ? &booking : nullptr);
    counts.direct += resolved.direct;
    counts.unsolved += resolved.unsolved;
  }
  return counts;
}

}  // namespace wells
