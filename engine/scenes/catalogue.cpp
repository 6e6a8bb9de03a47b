#include "scenes/catalogue.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "math/find_by_name.h"
#include "scenes/crowds.h"
#include "scenes/flat_gas.h"
#include "scenes/ground_scenes.h"
#include "scenes/impact_scenes.h"
#include "scenes/piles.h"
#include "scenes/sim_benchmark.h"
#include "scenes/wall_scenes.h"
#include "scenes/well_scenes.h"

namespace wells {
namespace {

constexpr Scene kScenes[] = {
    {"T1", "heaps: balls fall from a lattice and collapse onto four wells", 10000, 0, 300, false,
     makeWellsCrowd},
    {"T2", "gas: elastic, frictionless, without forces", 10000, 0, 300, false, makeGas},
    {"T3", "settled: one layer of balls at rest on the ground", 10000, 0, 300, true,
     makeSettledLayer},
    {"flat-gas", "gas in one layer: elastic, frictionless, without forces", 4000, 0, 300, false,
     makeFlatGas},
    {"cooling-gas", "the same with 100 balls whose impacts take energy", 100, 100, 120, false,
     makeCoolingGas},
    {"template", "the world of config/template.txt with one well", 25, 0, 600, false,
     makeTemplateWorld},
    {"bounce", "a ball bounces on the ground without loss", 1, 1, 600, false, makeElasticBounce},
    {"zeno", "a ball bounces, infinitely often, until it rests after 9.1 s", 1, 1, 360, false,
     makeZeno},
    {"zeno-rest", "the same with more loss: it rests after 3 s", 1, 1, 240, false, makeZenoRest},
    {"slide-to-roll", "a ball slides on the ground until friction makes it roll", 1, 1, 180, false,
     makeSlideToRoll},
    {"backspin", "a ball slides against its spin", 1, 1, 180, false, makeBackspin},
    {"backspin-return", "a ball spins so fast that it comes back", 1, 1, 180, false,
     makeBackspinReturn},
    {"rolling-well", "a ball on the ground rolls to and fro under a well", 1, 1, 600, false,
     makeRollingUnderWell},
    {"rolling-stops", "rolling resistance: a ball slides, rolls and stops", 1, 1, 180, false,
     makeRollingStops},
    {"stuck-under-a-well", "rolling resistance holds a ball beside a well that drew it", 1, 1, 600,
     false, makeStuckUnderWell},
    {"whispering-gallery", "a ball runs along the wall", 1, 1, 600, false, makeWhisperingGallery},
    {"wall-slide-to-roll", "the same with friction: it slides, then rolls", 1, 1, 300, false,
     makeWallSlideToRoll},
    {"wall-rolling", "a ball rolls round the wall, falls and rises again", 1, 1, 600, false,
     makeWallRolling},
    {"corner-slide-to-roll", "a ball between ground and wall slides, then rolls on both", 1, 1, 600,
     false, makeCornerSlideToRoll},
    {"corner-rolling", "a ball rolls on ground and wall at once, slowed by drag", 1, 1, 600, false,
     makeCornerRolling},
    {"oblique-ground", "two balls hit the ground with friction", 2, 2, 120, false,
     makeObliqueGround},
    {"oblique-balls", "a ball hits another off its centre", 2, 2, 120, false, makeObliqueBalls},
    {"friction-balls-stick", "two balls hit with friction and stick", 2, 2, 120, false,
     makeFrictionBallsStick},
    {"friction-balls-slip", "a spinning ball hits another and slips", 2, 2, 120, false,
     makeFrictionBallsSlip},
    {"billiard", "one ball hits a second, which hits a third", 3, 3, 180, false, makeBilliard},
    {"circle-billiard", "a ball runs round inside the wall, hit after hit", 1, 1, 60000, false,
     makeCircleBilliard},
    {"cradle", "Newton's cradle: a ball hits a row of four", 5, 5, 90, false, makeCradle},
    {"galperin", "a heavy ball drives a light one to the wall: 314 hits", 2, 2, 240, false,
     makeGalperin},
    {"collapse", "three balls lose their speeds to each other in infinitely many hits", 3, 3, 360,
     false, makeCollapse},
    {"collapse-twin", "the same with a little less loss: ten hits", 3, 3, 600, false,
     makeCollapseTwin},
    {"pile-stands", "a ball on three others, whose friction just holds them", 4, 4, 600, false,
     makeStandingPile},
    {"pile-slips", "the same with a little less friction: it falls", 4, 4, 60, false,
     makeSlippingPile},
    {"column", "ten balls exactly above each other", 10, 10, 60, false, makeColumn},
    {"heavy-on-light", "1000 t stand exactly above 1 kg", 2, 2, 600, false, makeHeavyOnLight},
    {"heavy-falls", "the same, nudged by a micrometre: it falls within 5 s", 2, 2, 240, false,
     makeNudgedHeavyOnLight},
    {"orbit", "a ball orbits a softened well in free space", 1, 1, 1200, false, makeOrbit},
    {"orbit-short", "the same, not yet once round", 1, 1, 120, false, makeOrbit},
    {"circular-orbit", "a ball circles a softened well", 1, 1, 1200, false, makeCircularOrbit},
    {"through-the-centre", "a ball swings through the centre of a well", 1, 1, 600, false,
     makeThroughTheCentre},
    {"well-bounces", "a ball bounces on the ground beneath a well", 1, 1, 360, false,
     makeWellBounces},
    {"well-bounces-long", "the same for eleven bounces", 1, 1, 960, false, makeWellBounces},
    {"bouncing", "SimBenchmark's 49 balls bounce on the ground without loss", 49, 49, 1200, false,
     makeBouncing},
    {"666", "SimBenchmark's block of 216 balls collapses and runs apart, without friction", 216,
     216, 600, false, makeBlock},
    {"elastic-666", "SimBenchmark's block of 216 balls bounces apart without loss", 216, 216, 600,
     false, makeElasticBlock},
};

}  // namespace

std::span<const Scene> scenes() {
  return kScenes;
}

const Scene& findScene(std::string_view name) {
  return findByName(kScenes, &Scene::name, "scene", name);
}

World makeScene(const Scene& scene, std::size_t balls, std::uint64_t seed) {
  if (scene.fixedBalls != 0 && balls != 0 && balls != scene.fixedBalls)
    throw std::invalid_argument(fmt::format("scene '{}' is made for {} ball(s); {} were asked for",
                                            scene.name, scene.fixedBalls, balls));
  return scene.make(balls != 0 ? balls : scene.defaultBalls, seed);
}

}  // namespace wells
