// How long a step takes that finds candidate pairs: Bullet's broadphases, used in several ways, and
// the grid, on the motion of heaps (T1) and of a gas (T2).
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "broadphase/grid_broadphase.h"
#include "scenes/catalogue.h"
#include "world/advance.h"
#include "world/candidates.h"
#include "world/simulation.h"

namespace wells {
namespace {

/// What a broadphase is given at a step.
struct Frame {
  std::vector<Vec3> position, velocity;
  std::vector<double> reach;
};

struct Motion {
  World world;
  std::vector<Frame> frames;
  std::vector<std::uint32_t> all;
};

constexpr int kFirstStep = 200;
constexpr int kFrames = 32;

const Motion& motionOf(const std::string& scene, std::int64_t balls) {
  static std::map<std::pair<std::string, std::int64_t>, Motion> made;
  Motion& motion = made[{scene, balls}];
  if (!motion.frames.empty()) return motion;
  motion.world = makeScene(findScene(scene), static_cast<std::size_t>(balls));
  World& world = motion.world;
  const auto simulation = makeSimulation();
  for (int step = 0; step < kFirstStep + kFrames; ++step) {
    if (step >= kFirstStep) {
      Field field;
      updateField(world, world.step, field);
      Frame frame{world.balls.position, world.balls.velocity, {}};
      for (std::size_t i = 0; i < world.balls.size(); ++i)
        frame.reach.push_back(
            reachOf(field, world.balls.state(i), world.balls.radius[i], world.settings.dt));
      motion.frames.push_back(std::move(frame));
    }
    simulation->step(world);
  }
  motion.all.resize(world.balls.size());
  std::iota(motion.all.begin(), motion.all.end(), 0u);
  return motion;
}

/// The number of the frame of a step: forward and back again, so that nothing jumps.
std::size_t frameOf(std::size_t step) {
  const std::size_t at = step % (2 * kFrames - 2);
  return at < kFrames ? at : 2 * kFrames - 2 - at;
}

/// One step after the other with step(frame), which returns the number of pairs.
template <class Step>
void replay(benchmark::State& state, const Motion& motion, Step step) {
  std::size_t at = 0;
  for (; at < 4; ++at) step(motion.frames[frameOf(at)]);
  double pairs = 0;
  for (auto _ : state) {
    pairs += static_cast<double>(step(motion.frames[frameOf(at)]));
    ++at;
  }
  state.counters["pairs"] = pairs / static_cast<double>(state.iterations());
}

/// Ours: the pairs of balls and of the arena, narrowed and sorted.
void ours(benchmark::State& state, const std::string& scene, BroadphaseKind kind) {
  const Motion& motion = motionOf(scene, state.range(0));
  World world = motion.world;
  world.settings.broadphase = kind;
  Candidates candidates;
  replay(state, motion, [&](const Frame& frame) {
    world.balls.position = frame.position;
    world.balls.velocity = frame.velocity;
    candidates.find(world, frame.reach, motion.all);
    return candidates.ballPairs().size();
  });
}

/// One of Bullet's interface with its own pair cache, and no more than that: boxes are set anew
/// when the ball has left them, and then are larger by `skin` (m).
void bullets(benchmark::State& state, const std::string& scene, btBroadphaseInterface& broadphase,
             double skin) {
  const Motion& motion = motionOf(scene, state.range(0));
  std::vector<btBroadphaseProxy*> proxies(motion.all.size());
  const auto corner = [&](const Frame& frame, std::size_t i, double sign, double fat) {
    const double half = motion.world.balls.radius[i] + frame.reach[i] + fat;
    const Vec3& x = frame.position[i];
    return btVector3(x.x() + sign * half, x.y() + sign * half, x.z() + sign * half);
  };
  for (std::size_t i = 0; i < proxies.size(); ++i)
    proxies[i] =
        broadphase.createProxy(corner(motion.frames[0], i, -1, skin),
                               corner(motion.frames[0], i, 1, skin), 0, nullptr, 1, 1, nullptr);
  replay(state, motion, [&](const Frame& frame) {
    for (std::size_t i = 0; i < proxies.size(); ++i) {
      const btVector3 low = corner(frame, i, -1, 0);
      const btVector3 high = corner(frame, i, 1, 0);
      bool isInside = true;
      for (int k = 0; k < 3; ++k)
        isInside &= low[k] >= proxies[i]->m_aabbMin[k] && high[k] <= proxies[i]->m_aabbMax[k];
      if (!isInside)
        broadphase.setAabb(proxies[i], corner(frame, i, -1, skin), corner(frame, i, 1, skin),
                           nullptr);
    }
    broadphase.calculateOverlappingPairs(nullptr);
    return static_cast<std::size_t>(broadphase.getOverlappingPairCache()->getNumOverlappingPairs());
  });
  broadphase.getOverlappingPairCache()->getOverlappingPairArray().clear();
  for (auto* const proxy : proxies) broadphase.destroyProxy(proxy, nullptr);
}

void tree(benchmark::State& state, const std::string& scene, bool isDeferred, double skin) {
  btDbvtBroadphase broadphase;
  broadphase.m_deferedcollide = isDeferred;
  bullets(state, scene, broadphase, skin);
}

void sweep(benchmark::State& state, const std::string& scene, double skin) {
  const auto most = static_cast<unsigned>(state.range(0)) + 16;
  bt32BitAxisSweep3 broadphase({-100, -100, -100}, {100, 100, 100}, most);
  bullets(state, scene, broadphase, skin);
}

void grid(benchmark::State& state, const std::string& scene, double skin) {
  btHashedOverlappingPairCache cache;
  GridBroadphase broadphase(&cache);
  bullets(state, scene, broadphase, skin);
}

void addAll() {
  for (const std::string scene : {"T1", "T2"}) {
    const auto add = [&](const std::string& name, auto run) {
      benchmark::RegisterBenchmark((scene + "/" + name).c_str(), run)
          ->Arg(25)
          ->Arg(1000)
          ->Arg(10'000)
          ->Unit(benchmark::kMicrosecond);
    };
    using State = benchmark::State;
    add("ours, tree", [=](State& s) { ours(s, scene, BroadphaseKind::Tree); });
    add("ours, grid", [=](State& s) { ours(s, scene, BroadphaseKind::Grid); });
    for (const double skin : {0.0, 0.25}) {
      const std::string with = skin > 0 ? ", skin 0.25 m" : "";
      add("btDbvtBroadphase" + with, [=](State& s) { tree(s, scene, false, skin); });
      add("btDbvtBroadphase, deferred" + with, [=](State& s) { tree(s, scene, true, skin); });
      add("bt32BitAxisSweep3" + with, [=](State& s) { sweep(s, scene, skin); });
      add("GridBroadphase" + with, [=](State& s) { grid(s, scene, skin); });
    }
  }
}

[[maybe_unused]] const bool areRegistered = (addAll(), true);

}  // namespace
}  // namespace wells
