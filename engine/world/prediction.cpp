#include "world/prediction.h"

#include <algorithm>

#include "world/advance.h"
#include "world/contact_memory.h"
#include "world/exact_flight.h"

namespace wells {
namespace {

constexpr std::uint32_t kBall = 0;

/// One ball, alone with ground and wall; as Simulation does it.
class LoneBall {
 public:
  explicit LoneBall(const World& world)
      : world_(world), integrator_(findIntegrator(world.settings.integrator)) {}

  void step(const Field& field, Balls& ball) {
    const BallState start = ball.state(kBall);
    if (!isFinite(start)) return;
    reach_ = reachOf(field, start, ball.radius[kBall], world_.settings.dt);
    for (int attempts = 1; !attempt(field, ball, attempts); ++attempts) ball.setState(kBall, start);
    memory_.forget(substep_);
    for (const Contact& c : plan_.arenaContacts) memory_.add(c);
    memory_.arrange();
  }

 private:
  /// False: the reach was too short and has been enlarged.
  bool attempt(const Field& field, Balls& ball, int attempts) {
    const Vec3 start = ball.position[kBall];
    findContacts(ball);
    const StepInput input(world_, field, integrator_);
    const ContactMethod method = methodOf(world_.settings, field, integrator_);
    if (method != ContactMethod::Substep && !pairs_.empty()) {
      const IslandFate fate = exact_.run(input, {&kBall, 1}, pairs_, {&reach_, 1}, ball);
      if (fate == IslandFate::TooFar && attempts <= kMostExactAttempts) return false;
      if (fate == IslandFate::Done || fate == IslandFate::Alone) plan_.arenaContacts.clear();
      if (fate == IslandFate::Done) return true;
    }
    for (Contact& c : plan_.arenaContacts) memory_.start(c, substep_);
    plan_.free.clear();
    plan_.touching.clear();
    (plan_.arenaContacts.empty() ? plan_.free : plan_.touching).push_back(kBall);
    advance(world_.settings, input.model, plan_, ball, pool_);
    return !isReachTooShort(start, ball);
  }

  /// As the simulation has it; it is then enlarged.
  bool isReachTooShort(const Vec3& start, const Balls& ball) {
    const BallState now = ball.state(kBall);
    if (!(length(now.position - start) > reach_) ||
        !hasMissedArena(world_.arena, start, now.position, ball.radius[kBall], reach_))
      return false;
    enlargeReach(start, now, world_.settings.dt, reach_);
    return true;
  }

  void findContacts(const Balls& ball) {
    pairs_.clear();
    plan_.arenaContacts.clear();
    // In order of the partner's number, as the simulation has them.
    for (const std::uint32_t partner : {kWall, kGround})
      if (mayTouchArena(world_.arena, ball.position[kBall], ball.radius[kBall], reach_, partner))
        pairs_.push_back({kBall, partner});
    for (const auto& [a, b] : pairs_) plan_.arenaContacts.push_back({.a = a, .b = b});
  }

  const World& world_;
  const Integrator& integrator_;
  std::vector<BallPair> pairs_;
  StepPlan plan_;
  ThreadPool pool_;
  ContactMemory memory_;
  ExactFlight exact_;
  double substep_ = world_.settings.dt / world_.settings.substeps;  // s
  double reach_ = 0;                                                // m
};

}  // namespace

BallState predict(const World& world, std::size_t ball, const BallState& state, std::int64_t from,
                  std::int64_t to) {
  if (!world.leaning.empty() && world.leaning[ball] != 0) {
    BallState drifted = state;
    const auto steps = static_cast<double>(std::max<std::int64_t>(0, to - from));
    drifted.position += (steps * world.settings.dt) * state.velocity;
    return drifted;
  }
  Balls alone;
  alone.add(state, world.balls.radius[ball], world.balls.mass[ball]);
  LoneBall lone(world);
  Field field;
  for (std::int64_t step = from; step < to; ++step) {
    updateField(world, step, field);
    lone.step(field, alone);
  }
  return alone.state(0);
}

}  // namespace wells
