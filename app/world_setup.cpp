#include "world_setup.h"

#include <fmt/format.h>

#include <vector>

#include "ball_file.h"
#include "errors.h"
#include "keys.h"
#include "math/hash.h"
#include "scenes/scatter.h"
#include "values.h"

namespace wells {
namespace {

bool stretchesStep(std::string_view engine) {
  return engine.starts_with("reference");
}

void requireFits(const Config& config, double ballRadius, const std::string& what) {
  if (ballRadius < config.arena.radius) return;
  throw UsageError(
      fmt::format("{}={}: a ball as wide as the arena; allowed: less than "
                  "SurfaceRadius={} (m)",
                  what, ballRadius, config.arena.radius));
}

void addScatteredBalls(World& world, const Config& config) {
  requireFits(config, config.ballRadius, "BallRadius");
  try {
    scatterBalls(world, static_cast<std::size_t>(config.ballCount), config.ballRadius,
                 config.ballMass, config.seed);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("NumOfBalls={}: {}; allowed: balls that fit into the arena",
                                 config.ballCount, error.what()));
  }
}

std::string ballsHash(const Balls& balls) {
  Hash hash;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    hash.add(balls.position[i]);
    hash.add(balls.velocity[i]);
    hash.add(balls.spin[i]);
    hash.add(balls.radius[i]);
    hash.add(balls.mass[i]);
  }
  return fmt::format("{}-balls-{:016x}", balls.size(), hash.value());
}

std::string hashOfLines(const std::vector<std::string>& lines) {
  Hash hash;
  for (const std::string& line : lines) hash.add(std::string_view(line));
  return fmt::format("{}-wells-{:016x}", lines.size(), hash.value());
}

bool comesFromBallsFile(const Key& key) {
  return key.name == "NumOfBalls" || key.name == "BallRadius" || key.name == "BallMass" ||
         key.name == "Seed";
}

enum class Wells { Listed, Hashed };

std::vector<std::string> canonicalValues(const Key& key, const Config& config, const Balls& initial,
                                         Wells wells) {
  if (key.name == "BallsFile" && !config.ballsFile.empty()) return {ballsHash(initial)};
  if (comesFromBallsFile(key) && !config.ballsFile.empty()) return {};
  const auto values = key.get(config);
  if (values == key.get(Config{})) return {};
  if (key.name == "Well" && wells == Wells::Hashed) return {hashOfLines(values)};
  return values;
}

std::string canonicalText(const Config& config, std::string_view engine, const Balls& initial,
                          Wells wells) {
  std::string text;
  for (const Key& key : keys()) {
    if (key.scope != Scope::World) continue;
    for (const std::string& value : canonicalValues(key, config, initial, wells))
      text += fmt::format("{}={}\n", key.name, value);
  }
  if (engine != "ours") text += fmt::format("engine={}\n", engine);
  return text;
}

}  // namespace

double stepLength(const Config& config, std::string_view engine) {
  return config.settings.dt * (stretchesStep(engine) ? config.timeScale : 1);
}

World makeWorld(const Config& config, std::string_view engine) {
  World world;
  world.settings = config.settings;
  world.settings.dt = stepLength(config, engine);
  world.arena = config.arena;
  for (const Well& well : config.wells) {
    world.tracks.push_back({.keyframes = {{.position = well.position, .strength = well.strength}},
                            .softening = well.softening});
  }
  if (config.ballsFile.empty()) {
    addScatteredBalls(world, config);
  } else {
    world.balls = readBalls(config.ballsFile);
    for (const double radius : world.balls.radius)
      requireFits(config, radius, config.ballsFile.string() + ": radius");
  }
  return world;
}

std::string canonicalConfig(const Config& config, std::string_view engine, const Balls& initial) {
  const std::string text = canonicalText(config, engine, initial, Wells::Listed);
  if (text.size() <= kCanonicalLimit) return text;
  return canonicalText(config, engine, initial, Wells::Hashed);
}

double stepRate(const Config& config, std::string_view engine) {
  const double rate = config.simulationRate > 0 ? config.simulationRate : 1 / config.settings.dt;
  return stretchesStep(engine) ? rate : rate * config.timeScale;
}

}  // namespace wells
