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

/// A layer at rest.
World layer() {
  return scene("T3", 1000);
}

constexpr FeatureScene kHeap = {"T1, 1,000, heaped", heap};
constexpr FeatureScene kFalling = {"T1, 1,000, falling", falling};
constexpr FeatureScene kGas = {"T2, 2,000", gas};
constexpr FeatureScene kLayer = {"T3, 1,000, at rest", layer};

FeatureRun engineOn(World start) {
  const auto world = std::make_shared<World>(std::move(start));
  const std::shared_ptr<Stepper> stepper = makeEngine("ours");
  return {.step = [world, stepper] { stepper->step(*world); }};
}

/// The same world each time: what the ratios differ by is noise.
FeatureRun nothing(World start, Presence, const fs::path&) {
  return engineOn(std::move(start));
}

FeatureRun friction(World start, Presence presence, const fs::path&) {
  start.settings.friction = presence == Presence::Absent ? 0 : 0.3;
  return engineOn(std::move(start));
}

FeatureRun rolling(World start, Presence presence, const fs::path&) {
  if (presence != Presence::Absent) start.settings.rollingResistance = 0.01;
  return engineOn(std::move(start));
}

FeatureRun fourWells(World start, Presence presence, const fs::path&) {
  if (presence == Presence::Absent) start.tracks.clear();
  if (presence == Presence::Unused)
    for (WellTrack& track : start.tracks)
      for (WellKeyframe& key : track.keyframes) key.strength = 0;
  return engineOn(std::move(start));
}

FeatureRun drag(World start, Presence presence, const fs::path&) {
  start.settings.drag = presence == Presence::Used ? 0.9 : 1;
  return engineOn(std::move(start));
}

FeatureRun gravity(World start, Presence presence, const fs::path&) {
  start.settings.gravity = {0, presence == Presence::Used ? -9.81 : 0, 0};
  return engineOn(std::move(start));
}

/// The last ball is alone, high up.
FeatureRun unequalBalls(World start, Presence presence, const fs::path&) {
  Balls& balls = start.balls;
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
  return engineOn(std::move(start));
}

/// After a second, in which all of a layer have come to rest.
FeatureRun sleep(World start, Presence presence, const fs::path&) {
  if (presence != Presence::Absent) start.settings.sleepSpeed = Settings{}.sleepSpeed;
  FeatureRun run = engineOn(std::move(start));
  for (int step = 0; step < 60; ++step) run.step();
  return run;
}

FeatureRun ghosts(World start, Presence presence, const fs::path&) {
  if (presence != Presence::Absent) start.roles.resize(start.balls.size(), Role::Owned);
  if (presence == Presence::Used)
    for (std::size_t i = 0; i < start.roles.size(); i += 2) start.roles[i] = Role::Ghost;
  return engineOn(std::move(start));
}

FeatureRun recording(World start, Presence presence, const fs::path&) {
  if (presence == Presence::Absent) return engineOn(std::move(start));
  return recordedRun(std::move(start),
                     presence == Presence::Used ? Recording::All : Recording::None);
}

FeatureRun pictures(World start, Presence presence, const fs::path& folder) {
  if (presence == Presence::Absent) return recordedRun(std::move(start), Recording::None);
  return watchedRun(std::move(start), presence == Presence::Used ? 30 : 1e-3, folder);
}

FeatureRun session(World start, Presence presence, const fs::path&) {
  if (presence == Presence::Absent) return engineOn(std::move(start));
  if (presence == Presence::Unused) return recordedRun(std::move(start), Recording::None);
  return sessionRun(start, 2);
}

constexpr Feature kFeatures[] = {
    {"nothing", nothing, "the same again", kHeap, "the same again", kHeap},
    {"friction", friction, "nothing touches", kFalling, "in a heap", kHeap},
    {"rolling resistance", rolling, "nothing touches", kFalling, "in a heap", kHeap},
    {"wells", fourWells, "four of strength 0", kHeap, "four", kHeap},
    {"drag", drag, "", kHeap, "factor 0.9 a second", kHeap},
    {"gravity", gravity, "", kGas, "9.81 m/s^2", kGas},
    {"unequal balls", unequalBalls, "one, alone", kHeap, "radii and masses at random", kHeap},
    {"sleep", sleep, "nobody rests", kHeap, "all of a layer sleep", kLayer},
    {"ghosts", ghosts, "roles, all owned", kGas, "every second ball", kGas},
    {"books and measures", recording, "a recorder that nobody asks", kHeap, "in each step", kHeap},
    {"view", pictures, "a context, no frame due", kHeap, "30 frames a simulated second", kHeap},
    {"session", session, "a peer that is alone", kGas, "of two peers", kGas},
};

}  // namespace

std::span<const Feature> features() {
  return kFeatures;
}

}  // namespace wells
