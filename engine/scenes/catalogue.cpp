#include "scenes/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/accuracy.h"
#include "scenes/crowds.h"

namespace wells {
namespace {

constexpr Scene kScenes[] = {
    {"T1", "heaps: balls fall from a lattice and collapse onto four wells", 10000, 0, 300, false,
     makeWellsCrowd},
    {"T2", "gas: elastic, frictionless, without forces", 10000, 0, 300, false, makeGas},
    {"T3", "settled: one layer of balls at rest on the ground", 10000, 0, 300, true,
     makeSettledLayer},
    {"template", "the world of config/template.txt with one well", 25, 0, 600, false,
     makeTemplateWorld},
    {"bounce", "a ball bounces on the ground without loss", 1, 1, 600, false, makeElasticBounce},
    {"slide-to-roll", "a ball slides on the ground until friction makes it roll", 1, 1, 180, false,
     makeSlideToRoll},
    {"billiard", "one ball hits a second, which hits a third", 3, 3, 180, false, makeBilliard},
    {"circle-billiard", "a ball runs round inside the wall, hit after hit", 1, 1, 60000, false,
     makeCircleBilliard},
    {"orbit", "a ball orbits a softened well in free space", 1, 1, 1200, false, makeOrbit},
};

}  // namespace

std::span<const Scene> scenes() {
  return kScenes;
}

const Scene& findScene(std::string_view name) {
  for (const Scene& scene : kScenes)
    if (scene.name == name) return scene;
  std::vector<std::string_view> names;
  for (const Scene& scene : kScenes) names.push_back(scene.name);
  throw std::invalid_argument(
      fmt::format("scene '{}' is unknown; allowed: {}", name, fmt::join(names, ", ")));
}

World makeScene(const Scene& scene, std::size_t balls, std::uint64_t seed) {
  if (scene.fixedBalls != 0 && balls != 0 && balls != scene.fixedBalls)
    throw std::invalid_argument(fmt::format("scene '{}' is made for {} ball(s); {} were asked for",
                                            scene.name, scene.fixedBalls, balls));
  return scene.make(balls != 0 ? balls : scene.defaultBalls, seed);
}

}  // namespace wells
