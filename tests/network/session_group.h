// Peers in one process on the network in memory, with simulated clocks, for tests of the session.
// After everything that any of them does, the promises that must always hold are checked.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "math/elementary.h"
#include "network/memory_transport.h"
#include "network/session.h"
#include "world/prediction.h"
#include "world/simulation.h"

namespace wells {

inline constexpr double kTick = 1.0 / 60;  // s
inline constexpr double kLease = 2;        // s

/// Balls in a grid of columns on an arena of 40 m, some of them in the air.
inline World testWorld(std::size_t balls) {
  World world;
  world.settings.gravity = {0, -9.81, 0};
  Random random(7);
  const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(balls))));
  for (std::size_t i = 0; i < balls; ++i) {
    const auto column = static_cast<double>(i % side);
    const auto row = static_cast<double>(i / side);
    const double spacing = 50.0 / side;
    const Vec3 position{(column + 0.5) * spacing - 25, 0.5 + random.uniform(0, 3),
                        (row + 0.5) * spacing - 25};
    world.balls.add({.position = position}, 0.5, 1);
  }
  return world;
}

/// Peer i's well circles on a path of its own.
inline OwnWell circlingWell(double period, double strength = 40) {
  return {.softening = 2, .at = [=](PeerId peer, std::int64_t step) {
            const CirclePath path{
                .center = {0, 0.5, 0}, .radius = 15, .period = period, .phase = 0.25 * value(peer)};
            return WellKeyframe{step, positionOnCircle(path, static_cast<double>(step) * kTick),
                                strength};
          }};
}

inline OwnWell restingWell(const Vec3& position, double strength = 40) {
  return {.softening = 2, .at = [=](PeerId, std::int64_t step) {
            return WellKeyframe{step, position, strength};
          }};
}

/// Options of peer `id`, seeded so that no two starts are alike.
inline SessionOptions testOptions(int id, std::uint64_t start = 0) {
  SessionOptions options;
  options.peer = PeerId{id};
  options.seed = static_cast<std::uint64_t>(id) * 1000 + start;
  options.lease = kLease;
  options.canonicalConfig = "BallRadius=0.5\nNumOfBalls=many\n";
  options.worldHash = 42;
  options.well = circlingWell(10);
  options.predict = predict;
  return options;
}

/// One peer as its program would run it.
struct TestPeer {
  TestPeer(SessionOptions options, World initial, std::shared_ptr<MemoryNetwork> network)
      : world(std::move(initial)),
        transport(std::make_unique<MemoryTransport>(std::move(network))),
        stepper(makeSimulation()) {
    options.notice = [this](const std::string& text) { notices.push_back(text); };
    session = std::make_unique<Session>(std::move(options), world, *transport);
  }
  std::size_t owned() const {
    return static_cast<std::size_t>(std::ranges::count(world.roles, Role::Owned));
  }

  World world;
  std::unique_ptr<MemoryTransport> transport;
  std::unique_ptr<Stepper> stepper;
  std::unique_ptr<Session> session;
  std::vector<std::string> notices;
  double clockOffset = 0;  // s, of its wall clock
  bool isStalled = false;  // its loop stands still (SIGSTOP)
  std::vector<Record> lastRecords;
  Incarnation lastSelf;  // whose they are
};

class Group {
 public:
  /// `prepare` changes the world and the settings with which every peer starts.
  explicit Group(std::size_t balls, std::uint64_t seed = 1, const MemoryFaults& faults = {},
                 std::function<void(World&)> prepare = {})
      : balls_(balls),
        prepare_(std::move(prepare)),
        network_(std::make_shared<MemoryNetwork>(seed, faults)) {}

  TestPeer& add(SessionOptions options) {
    World world = testWorld(balls_);
    if (prepare_) prepare_(world);
    peers_.push_back(std::make_unique<TestPeer>(std::move(options), std::move(world), network_));
    return *peers_.back();
  }

  /// As kill -9.
  void kill(TestPeer& peer) {
    std::erase_if(peers_, [&](const auto& other) { return other.get() == &peer; });
  }

  Times timesOf(const TestPeer& peer) const {
    constexpr std::int64_t kEpoch = 1'700'000'000'000'000;
    return {network_->now(),
            kEpoch + static_cast<std::int64_t>((network_->now() + peer.clockOffset) * 1e6)};
  }

  void tick() {
    network_->advance(kTick);
    for (auto& peer : peers_) {
      if (peer->isStalled) continue;
      const Times now = timesOf(*peer);
      const auto session = [&](auto call) {
        const World before = peer->world;
        call();
        expectAnnounced(before, peer->world);
      };
      session([&] { peer->session->beforeStep(peer->world, now); });
      check(*peer);
      const int steps = peer->session->mayStep(peer->world, now);
      for (int i = 0; i < steps; ++i) {
        peer->stepper->step(peer->world);
        session([&] { peer->session->afterStep(peer->world, now); });
      }
      if (steps == 0) session([&] { peer->session->afterStep(peer->world, now); });
      check(*peer);
    }
  }

  void run(double seconds) {
    const double end = network_->now() + seconds;
    while (network_->now() < end) tick();
  }

  /// True when `condition` comes to hold within so many seconds.
  bool runUntil(const std::function<bool()>& condition, double seconds) {
    const double end = network_->now() + seconds;
    while (!condition()) {
      if (network_->now() >= end) return false;
      tick();
    }
    return true;
  }

  bool allActive() const {
    return std::ranges::all_of(
        peers_, [](const auto& peer) { return peer->session->phase() == Phase::Active; });
  }

  bool allActiveInOneGeneration() const {
    return allActive() && std::ranges::all_of(peers_, [&](const auto& peer) {
             return peer->session->generation() == peers_.front()->session->generation();
           });
  }

  /// Peers that act as owner of a ball.
  int ownersOf(std::size_t ball) const {
    int owners = 0;
    for (const auto& peer : peers_)
      if (peer->world.roles[ball] == Role::Owned) ++owners;
    return owners;
  }

  bool everyBallHasOneOwner() const {
    for (std::size_t i = 0; i < balls_; ++i)
      if (ownersOf(i) != 1) return false;
    return true;
  }

  /// Stops all peers at a common step and waits until all say that their views are complete.
  bool settle(double seconds) {
    std::int64_t last = 0;
    for (const auto& peer : peers_) last = std::max(last, peer->world.step);
    for (const auto& peer : peers_) peer->session->stopAt(last + 60);
    return runUntil(
        [&] {
          return std::ranges::all_of(
              peers_, [](const auto& peer) { return peer->session->isComplete(peer->world); });
        },
        seconds);
  }

  /// Every view of every ball has the same bits, and so do the records.
  void expectEqualViews() const {
    const TestPeer& first = *peers_.front();
    for (const auto& peer : peers_) {
      EXPECT_EQ(peer->world.step, first.world.step);
      for (std::size_t i = 0; i < balls_; ++i) {
        EXPECT_EQ(peer->world.balls.position[i], first.world.balls.position[i]) << "ball " << i;
        EXPECT_EQ(peer->world.balls.velocity[i], first.world.balls.velocity[i]) << "ball " << i;
        EXPECT_EQ(peer->world.balls.spin[i], first.world.balls.spin[i]) << "ball " << i;
        EXPECT_EQ(peer->session->records()[i].version, first.session->records()[i].version);
      }
    }
  }

  std::vector<std::unique_ptr<TestPeer>>& peers() { return peers_; }
  MemoryNetwork& network() { return *network_; }
  const std::shared_ptr<MemoryNetwork>& sharedNetwork() { return network_; }
  std::size_t balls() const { return balls_; }

 private:
  using Tenure = std::tuple<std::size_t, Generation, std::int64_t, Incarnation, std::int64_t>;

  /// Whatever the session changes, the engine is told: it might be asleep.
  static void expectAnnounced(const World& before, const World& after) {
    const auto& changed = after.changed.list();
    for (std::uint32_t i = 0; i < after.balls.size(); ++i) {
      const BallState x = before.balls.state(i);
      const BallState y = after.balls.state(i);
      const bool isSame = x.position == y.position && x.velocity == y.velocity &&
                          x.spin == y.spin && before.roles[i] == after.roles[i];
      ASSERT_TRUE(isSame || std::ranges::find(changed, i) != changed.end()) << "ball " << i;
    }
  }

  /// A tenure has one owner ever; versions only rise; nothing is lost and nothing is NaN.
  void check(TestPeer& peer) {
    const std::vector<Record>& records = peer.session->records();
    ASSERT_EQ(records.size(), balls_);
    // A peer that stood still starts over as a new incarnation.
    if (peer.lastSelf != peer.session->self()) peer.lastRecords.clear();
    peer.lastSelf = peer.session->self();
    if (peer.session->phase() != Phase::Joining) {
      for (std::size_t i = 0; i < balls_; ++i) {
        const Version& v = records[i].version;
        ASSERT_TRUE(isFinite(peer.world.balls.position[i])) << "ball " << i;
        if (!peer.lastRecords.empty()) {
          if (records[i] == peer.lastRecords[i]) continue;
          ASSERT_GE(v, peer.lastRecords[i].version) << "ball " << i;
        }
        if (v.owner == Incarnation{}) continue;
        const auto [known, isNew] =
            owners_.try_emplace({i, v.generation, v.term, v.adopter, v.epoch}, v.owner);
        ASSERT_EQ(known->second, v.owner) << "two owners of ball " << i;
      }
      peer.lastRecords = records;
    }
  }

  std::size_t balls_;
  std::function<void(World&)> prepare_;
  std::shared_ptr<MemoryNetwork> network_;
  std::vector<std::unique_ptr<TestPeer>> peers_;
  std::map<Tenure, Incarnation> owners_;
};

}  // namespace wells
