#include "simulation/toy_world.h"

#include "math/random.h"

namespace wells::simulation {
namespace {

constexpr double kDt = 1 / kStepRate;         // s
constexpr double kStiffness = 2.5;            // 1/s^2, a swing takes 4 s
constexpr double kRadius = 10;                // m, of the swings and of the wells' circle
constexpr double kTurnPeriod = 2.5;           // s, of the wells
constexpr std::uint64_t kKnockInterval = 16;  // steps, on average

void advance(BallState& ball) {
  const Vec3 pull{ball.position.x(), 0, ball.position.z()};
  ball.velocity -= kStiffness * kDt * pull;
  ball.position += kDt * ball.velocity;
}

/// Turns the velocity by about 53 degrees to one side, and leaves a mark of who did it and when.
void knock(BallState& ball, std::uint64_t bits) {
  const double sine = (bits & 1) == 0 ? 0.8 : -0.8;
  const Vec3 v = ball.velocity;
  ball.velocity = {0.6 * v.x() - sine * v.z(), 0, sine * v.x() + 0.6 * v.z()};
  ball.spin.y() = static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace

World toyWorld(int balls) {
  World world;
  world.settings.dt = kDt;
  world.settings.gravity = Vec3::Zero();
  Random random(7);
  for (int i = 0; i < balls; ++i) {
    const double speed = kRadius;  // of the fastest: radius * 2 pi / period, about
    world.balls.add(
        {.position = {random.uniform(-kRadius, kRadius), 0.5, random.uniform(-kRadius, kRadius)},
         .velocity = {random.uniform(-speed, speed), 0, random.uniform(-speed, speed)}},
        0.5, 1);
  }
  return world;
}

void toyStep(World& world, PeerId peer) {
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    BallState ball = world.balls.state(i);
    advance(ball);
    if (world.owns(i)) {
      std::uint64_t mix = static_cast<std::uint64_t>(world.step) * 1024 + i * 256 +
                          static_cast<std::uint64_t>(value(peer));
      const std::uint64_t bits = splitmix64(mix);
      if (bits % kKnockInterval == 0) knock(ball, bits >> 8);
    }
    world.balls.setState(i, ball);
  }
  ++world.step;
}

BallState toyPredict(const World&, std::size_t, const BallState& state, std::int64_t from,
                     std::int64_t to) {
  BallState ball = state;
  for (std::int64_t step = from; step < to; ++step) advance(ball);
  return ball;
}

OwnWell toyWell() {
  return {.softening = 2, .at = [](PeerId peer, std::int64_t step) {
            // Golden section: apart for any set of ids.
            const CirclePath path{.center = {0, 0.5, 0},
                                  .radius = kRadius,
                                  .period = kTurnPeriod,
                                  .phase = 0.381966 * value(peer)};
            return WellKeyframe{step, positionOnCircle(path, static_cast<double>(step) * kDt), 40};
          }};
}

}  // namespace wells::simulation
