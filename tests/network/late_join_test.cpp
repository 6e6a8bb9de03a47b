// A peer that comes late into a large world. The balls drift in straight lines, so that any state
// is known in closed form, and every one of them is always due to be sent.
#include <gtest/gtest.h>

#include "session_group.h"

namespace wells {
namespace {

constexpr std::size_t kBalls = 10'000;

Vec3 velocityOf(std::size_t ball) {
  const auto i = static_cast<double>(ball);
  return {0.1 + 1e-5 * i, 0, 0.2 - 1e-5 * i};
}

Vec3 startOf(std::size_t ball) {
  return {static_cast<double>(ball % 100) - 50, 1, static_cast<double>(ball / 100) - 50};
}

BallState drifted(std::size_t ball, std::int64_t step) {
  const double t = static_cast<double>(step) * kTick;
  return {.position = startOf(ball) + t * velocityOf(ball), .velocity = velocityOf(ball)};
}

class Drift : public Stepper {
 public:
  std::string name() const override { return "drift"; }
  std::string integrator() const override { return ""; }
  std::string contactMethod() const override { return ""; }
  void step(World& world) override {
    ++world.step;
    for (std::size_t i = 0; i < world.balls.size(); ++i)
      world.balls.setState(i, drifted(i, world.step));
  }
};

TestPeer& addDrifting(Group& group, int id) {
  SessionOptions options = testOptions(id);
  options.well = restingWell({id == 1 ? -30.0 : 30.0, 0.5, 0});
  options.predict = [](const World& world, std::size_t, const BallState& state, std::int64_t from,
                       std::int64_t to) {
    BallState later = state;
    later.position += (static_cast<double>(to - from) * world.settings.dt) * state.velocity;
    return later;
  };
  TestPeer& peer = group.add(options);
  peer.stepper = std::make_unique<Drift>();
  return peer;
}

class LateJoin : public ::testing::TestWithParam<double> {};

TEST_P(LateJoin, IsActiveWithinThreeSecondsOfListeningAndHoldsTheOwnersStates) {
  Group group(kBalls);
  for (const int id : {1, 2}) addDrifting(group, id);
  ASSERT_TRUE(group.runUntil([&] { return group.allActiveInOneGeneration(); }, 20));
  group.run(2);
  group.network().setFaults({.loss = GetParam()});
  TestPeer& late = addDrifting(group, 3);
  group.run(2 * kLease);
  EXPECT_TRUE(group.runUntil([&] { return late.session->phase() == Phase::Active; },
                             GetParam() == 0 ? 3 : 10));

  const auto& known = group.peers().front()->session->records();
  std::size_t differing = 0;
  for (std::size_t i = 0; i < kBalls; ++i) {
    const Version& version = late.session->records()[i].version;
    if (!sameTenure(version, known[i].version)) ++differing;
    // Every state but those for which the work of prediction was too much is of now.
    const double behind =
        length(late.world.balls.position[i] - drifted(i, late.world.step).position) /
        length(velocityOf(i));
    EXPECT_LE(behind, kLease + 1) << "ball " << i;
  }
  EXPECT_LE(differing, kBalls / 100) << "but for those that change hands right now";
  group.network().setFaults({});
  group.run(3);
  for (std::size_t i = 0; i < kBalls; ++i)
    EXPECT_LE(length(late.world.balls.position[i] - drifted(i, late.world.step).position), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OnACleanAndOnABadNetwork, LateJoin, ::testing::Values(0.0, 0.3));

}  // namespace
}  // namespace wells
