#include "feature_list.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "engines.h"
#include "feature_peers.h"
#include "math/random.h"
#include "scenes/catalogue.h"
#include "state/stepper.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

World scene(const char* name, std::size_t balls) {
  World world = makeScene(findScene(name), balls);
  world.settings.sleepSpeed = 0;
  return world;
}

FeatureRun engineOn(World start) {
  const auto world = std::make_shared<World>(std::move(start));
  const std::shared_ptr<Stepper> stepper = makeEngine("ours");
  return {.step = [world, stepper] { stepper->step(*world); }};
}

/// Balls that have come down and lie on each other, about the wells.
World heap() {
  static const World settled = [] {
    World world = scene("T1", 1000);
    const auto stepper = makeEngine("ours");
    for (int step = 0; step < 60; ++step) stepper->step(world);
    return world;
  }();
  return settled;
}

/// The same balls high up: side by side in free fall, they may meet but never do.
World falling() {
  World world = scene("T1", 1000);
  world.tracks.clear();
  for (Vec3& position : world.balls.position) position.y() += 100;
  return world;
}

World gas() {
  return scene("T2", 2000);
}

FeatureRun frictionUnused(Presence presence, const fs::path&) {
  World world = falling();
  world.settings.friction = presence == Presence::Absent ? 0 : 0.3;
  return engineOn(std::move(world));
}

FeatureRun frictionUsed(Presence presence, const fs::path&) {
  World world = heap();
  if (presence == Presence::Absent) world.settings.friction = 0;
  return engineOn(std::move(world));
}

FeatureRun rollingUnused(Presence presence, const fs::path&) {
  World world = falling();
  if (presence != Presence::Absent) world.settings.rollingResistance = 0.01;
  return engineOn(std::move(world));
}

FeatureRun rollingUsed(Presence presence, const fs::path&) {
  World world = heap();
  if (presence != Presence::Absent) world.settings.rollingResistance = 0.01;
  return engineOn(std::move(world));
}

FeatureRun fourWells(Presence presence, const fs::path&) {
  World world = heap();
  if (presence == Presence::Absent) world.tracks.clear();
  if (presence == Presence::Unused)
    for (WellTrack& track : world.tracks)
      for (WellKeyframe& key : track.keyframes) key.strength = 0;
  return engineOn(std::move(world));
}

FeatureRun drag(Presence presence, const fs::path&) {
  World world = heap();
  world.settings.drag = presence == Presence::Used ? 0.9 : 1;
  return engineOn(std::move(world));
}

FeatureRun gravity(Presence presence, const fs::path&) {
  World world = gas();
  world.settings.gravity = {0, presence == Presence::Used ? -9.81 : 0, 0};
  return engineOn(std::move(world));
}

/// The last ball is alone, high up.
FeatureRun unequalBalls(Presence presence, const fs::path&) {
  World world = heap();
  Balls& balls = world.balls;
  balls.position.back().y() += 100;
  if (presence == Presence::Unused) {
    balls.radius.back() = 0.6;
    balls.mass.back() = 2;
  }
  Random random(1);
  if (presence == Presence::Used)
    for (std::size_t i = 0; i < balls.size(); ++i) {
      balls.radius[i] *= random.uniform(0.9, 1);
      balls.mass[i] *= random.uniform(0.5, 1);
    }
  return engineOn(std::move(world));
}

FeatureRun sleepUnused(Presence presence, const fs::path&) {
  World world = heap();
  if (presence != Presence::Absent) world.settings.sleepSpeed = Settings{}.sleepSpeed;
  return engineOn(std::move(world));
}

/// A layer in which all have rested for a second.
FeatureRun sleepUsed(Presence presence, const fs::path&) {
  World world = scene("T3", 1000);
  if (presence != Presence::Absent) world.settings.sleepSpeed = Settings{}.sleepSpeed;
  FeatureRun run = engineOn(std::move(world));
  for (int step = 0; step < 60; ++step) run.step();
  return run;
}

FeatureRun ghosts(Presence presence, const fs::path&) {
  World world = gas();
  if (presence != Presence::Absent) world.roles.resize(world.balls.size(), Role::Owned);
  if (presence == Presence::Used)
    for (std::size_t i = 0; i < world.roles.size(); i += 2) world.roles[i] = Role::Ghost;
  return engineOn(std::move(world));
}

FeatureRun recording(Presence presence, const fs::path&) {
  if (presence == Presence::Absent) return engineOn(heap());
  return recordedRun(heap(), presence == Presence::Used ? Recording::All : Recording::None);
}

FeatureRun pictures(Presence presence, const fs::path& folder) {
  if (presence == Presence::Absent) return recordedRun(heap(), Recording::None);
  return watchedRun(heap(), presence == Presence::Used ? 30 : 1e-3, folder);
}

FeatureRun session(Presence presence, const fs::path&) {
  if (presence == Presence::Absent) return engineOn(gas());
  if (presence == Presence::Unused) return recordedRun(gas(), Recording::None);
  return sessionRun(gas(), 2);
}

constexpr std::string_view kHeap = "T1, 1,000, heaped";
constexpr std::string_view kFalling = "T1, 1,000, falling";
constexpr std::string_view kGas = "T2, 2,000";

constexpr Feature kFeatures[] = {
    {"friction", kFalling, "nothing touches", frictionUnused, "in a heap", frictionUsed, kHeap},
    {"rolling resistance", kFalling, "nothing touches", rollingUnused, "in a heap", rollingUsed,
     kHeap},
    {"wells", kHeap, "four of strength 0", fourWells, "four"},
    {"drag", kHeap, "factor 1", drag, "factor 0.9 a second"},
    {"gravity", kGas, "0 m/s^2", gravity, "9.81 m/s^2"},
    {"unequal balls", kHeap, "one, alone", unequalBalls, "radii and masses at random"},
    {"sleep", kHeap, "nobody rests", sleepUnused, "all of a layer sleep", sleepUsed,
     "T3, 1,000, at rest"},
    {"ghosts", kGas, "roles, all owned", ghosts, "every second ball"},
    {"books and measures", kHeap, "a recorder that nobody asks", recording, "in each step"},
    {"view", kHeap, "a context, no frame due", pictures, "30 frames a simulated second"},
    {"session", kGas, "a peer that is alone", session, "of two peers"},
};

}  // namespace

std::span<const Feature> features() {
  return kFeatures;
}

}  // namespace wells
