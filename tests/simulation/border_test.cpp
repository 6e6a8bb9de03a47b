// Balls where two or more wells are about as near: at most one hand-over for each crossing of the
// hysteresis band, and ties that break the same way everywhere. Balls move on given paths, so that
// the crossings can be counted apart from the sessions.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "math/elementary.h"
#include "network/memory_transport.h"
#include "network/session.h"
#include "network/wells_exchange.h"

namespace wells::simulation {
namespace {

constexpr double kTick = 1.0 / 60;  // s
constexpr double kLease = 2;        // s

using Path = std::function<Vec3(std::int64_t step)>;
using WellPlace = std::function<Vec3(int peer, std::int64_t step)>;

struct Peer {
  Peer(int id, const Path& path, const WellPlace& place, std::shared_ptr<MemoryNetwork> network)
      : transport(std::move(network)) {
    world.balls.add({.position = path(0)}, 0.5, 1);
    SessionOptions options;
    options.peer = PeerId{id};
    options.seed = static_cast<std::uint64_t>(id);
    options.lease = kLease;
    options.well.at = [=](PeerId peer, std::int64_t step) {
      return WellKeyframe{step, place(value(peer), step), 40};
    };
    options.predict = [=](const World&, std::size_t, const BallState&, std::int64_t,
                          std::int64_t to) { return BallState{.position = path(to)}; };
    session = std::make_unique<Session>(std::move(options), world, transport);
  }
  World world;
  MemoryTransport transport;
  std::unique_ptr<Session> session;
};

/// One ball and `count` peers, in one session and past its beginning.
class Border {
 public:
  Border(int count, const Path& path, const WellPlace& place) : path_(path) {
    for (int id = 1; id <= count; ++id)
      peers_.push_back(std::make_unique<Peer>(id, path, place, network_));
    run(2 * kLease + 4);
    for (const auto& peer : peers_) EXPECT_EQ(peer->session->phase(), Phase::Active);
    holder_ = owner();
    before_ = handovers();
  }

  void run(double seconds) {
    for (const double end = network_->now() + seconds; network_->now() < end;) {
      network_->advance(kTick);
      for (const auto& peer : peers_) tick(*peer);
      countCrossing();
    }
  }

  void kill(PeerId id) {
    std::erase_if(peers_, [&](const auto& peer) { return peer->session->peer() == id; });
  }

  /// Whoever acts as owner; nobody while a hand-over is under way.
  PeerId owner() const {
    PeerId owner = kNobody;
    for (const auto& peer : peers_) {
      if (peer->world.roles[0] != Role::Owned) continue;
      EXPECT_EQ(owner, kNobody) << "two owners";
      owner = peer->session->peer();
    }
    return owner;
  }
  std::int64_t handovers() const {
    std::int64_t taken = 0;
    for (const auto& peer : peers_) taken += peer->session->counts().balls.handoversTaken;
    return taken - before_;
  }
  std::int64_t adoptions() const {
    std::int64_t adopted = 0;
    for (const auto& peer : peers_) adopted += peer->session->counts().balls.adoptions;
    return adopted;
  }
  /// Since the beginning: how often another well became nearer, by the rule, than that of the one
  /// before.
  int crossings() const { return crossings_; }

 private:
  void tick(Peer& peer) {
    const Times now{network_->now(),
                    1'700'000'000'000'000 + static_cast<std::int64_t>(network_->now() * 1e6)};
    peer.session->beforeStep(peer.world, now);
    const int steps = peer.session->mayStep(peer.world, now);
    for (int i = 0; i < steps; ++i) {
      ++peer.world.step;
      peer.world.balls.position[0] = path_(peer.world.step);
      peer.session->afterStep(peer.world, now);
    }
    if (steps == 0) peer.session->afterStep(peer.world, now);
  }

  void countCrossing() {
    const World& world = peers_.front()->world;
    const Vec3 ball = path_(world.step);
    const auto wells = peerWells(world);
    const auto held = std::ranges::find(wells, holder_, &PeerWell::peer);
    if (held == wells.end()) return;
    const HandoverRule rule;
    const double limit = rule.ratio * length(held->position - ball) - rule.margin;
    const auto nearest = std::ranges::min_element(
        wells, {}, [&](const PeerWell& well) { return length(well.position - ball); });
    if (length(nearest->position - ball) >= limit) return;
    holder_ = nearest->peer;
    ++crossings_;
  }

  Path path_;
  std::shared_ptr<MemoryNetwork> network_ =
      std::make_shared<MemoryNetwork>(1, MemoryFaults{.delay = 0.005, .jitter = 0.01});
  std::vector<std::unique_ptr<Peer>> peers_;
  PeerId holder_ = kNobody;
  int crossings_ = 0;
  std::int64_t before_ = 0;
};

Vec3 leftAndRight(int peer, std::int64_t) {
  return {peer == 1 ? -10.0 : 10.0, 0, 0};
}

Path orbit(double radius, double period) {
  return [=](std::int64_t step) {
    return positionOnCircle({.radius = radius, .period = period},
                            static_cast<double>(step) * kTick);
  };
}

TEST(Border, ABallThatOrbitsOnItIsHandedOverAtMostOnceForEachCrossing) {
  for (const double radius : {0.5, 0.7, 0.78, 0.8, 0.85, 1.0, 3.0, 12.0}) {
    for (const double period : {0.05, 0.3, 1.0, 2.5, 6.0}) {
      Border border(2, orbit(radius, period), leftAndRight);
      border.run(20);
      EXPECT_LE(border.handovers(), border.crossings()) << radius << " m, " << period << " s";
      if (radius < 0.75) {
        EXPECT_EQ(border.handovers(), 0) << "never leaves the band";
      }
      if (radius >= 1 && period >= 2.5) {
        EXPECT_GE(border.handovers(), border.crossings() - 1) << radius << " m, " << period << " s";
      }
    }
  }
}

TEST(Border, WellsThatSwapPlacesGiveAtMostOneHandOverForEachSwap) {
  for (const std::int64_t swap : {60, 30, 12, 6, 3, 1}) {  // steps
    const auto swapping = [=](int peer, std::int64_t step) {
      return leftAndRight(step / swap % 2 == 0 ? peer : 3 - peer, step);
    };
    Border border(
        2,
        [](std::int64_t) {
          return Vec3{6, 0, 0};
        },
        swapping);
    border.run(30);
    EXPECT_LE(border.handovers(), border.crossings()) << "each " << swap << " steps";
    if (swap == 60) {
      EXPECT_GE(border.handovers(), 28);
    }
  }
}

TEST(Border, ABallAsNearToFourWellsStaysWithItsOwnerAndIsAdoptedByOne) {
  const auto corners = [](int peer, std::int64_t) {
    return Vec3{peer % 2 == 0 ? 10.0 : -10.0, 0, peer > 2 ? 10.0 : -10.0};
  };
  Border border(
      4,
      [](std::int64_t) {
        return Vec3{0, 0, 0};
      },
      corners);
  const PeerId first = border.owner();
  ASSERT_NE(first, kNobody);
  border.run(10);
  EXPECT_EQ(border.handovers(), 0);
  EXPECT_EQ(border.owner(), first);
  border.kill(first);
  border.run(2 * kLease + 1);
  EXPECT_EQ(border.adoptions(), 1);
  EXPECT_EQ(border.owner(), first == PeerId{1} ? PeerId{2} : PeerId{1}) << "the lowest id left";
}

}  // namespace
}  // namespace wells::simulation
