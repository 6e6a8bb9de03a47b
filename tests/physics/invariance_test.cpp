// The cases with exact answers, seen from elsewhere: turned about the vertical by any angle,
// mirrored, moved with their arena and with other ids, twenty times each.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "support/run_world.h"
#include "support/transformed_world.h"

namespace wells {
namespace {

constexpr std::uint64_t kSeeds = 20;

struct Bound {
  const char* scene;
  double error;  // m, at the origin
  double away;   // m, with the arena up to 1 km away, where coordinates are rounded to 1e-13 m
};

/// Rounding at the origin counts 1e-15 m, a kilometre away 1e-13 m.
constexpr Bound kBounds[] = {
    {"bounce", 1e-9, 1e-9},
    {"zeno", 1e-9, 1e-9},
    {"zeno-rest", 1e-9, 1e-9},
    {"slide-to-roll", 1e-9, 1e-9},
    {"backspin", 1e-9, 1e-9},
    {"backspin-return", 1e-9, 1e-9},
    {"rolling-well", 1e-7, 1e-7},
    {"whispering-gallery", 1e-9, 1e-9},
    {"wall-slide-to-roll", 1e-9, 1e-9},
    {"wall-rolling", 1e-6, 1e-6},
    {"corner-slide-to-roll", 1e-9, 1e-9},
    {"corner-rolling", 1e-9, 1e-9},
    {"oblique-ground", 1e-9, 1e-9},
    {"oblique-balls", 1e-9, 1e-9},
    {"friction-balls-stick", 1e-9, 1e-9},
    {"friction-balls-slip", 1e-9, 1e-9},
    {"billiard", 1e-9, 1e-9},
    // The angle of each of 277 hits is rounded, and all later ones keep it: 277^(3/2) 10 m times
    // 1e-14 a kilometre away.
    {"circle-billiard", 1e-7, 1e-7},
    {"orbit", 1e-5, 1e-5},
    {"orbit-short", 1e-5, 1e-5},
    {"circular-orbit", 1.4e-6, 1.4e-6},
    {"through-the-centre", 1.5e-6, 1.5e-6},
    {"well-bounces", 1e-5, 1e-5},
    {"well-bounces-long", 1e-4, 1e-4},
};

/// positionError of a run of the scene seen through `seen`.
double errorSeen(const Scene& scene, const Transform& seen) {
  const AccuracyCase& answer = findAccuracyCase(scene.name);
  World world = seen.apply(makeScene(scene));
  runFor(world, answer.duration);
  World back = world;
  back.balls = seen.undo(world);
  return positionError(answer, back);
}

class Invariance : public testing::TestWithParam<Bound> {};

void PrintTo(const Bound& bound, std::ostream* out) {
  *out << bound.scene;
}

TEST_P(Invariance, TurnedMirroredShuffled) {
  const Scene& scene = findScene(GetParam().scene);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    EXPECT_LE(errorSeen(scene, randomTransform(seed, scene.fixedBalls, 0)), GetParam().error)
        << seed;
}

TEST_P(Invariance, FarFromTheOrigin) {
  const Scene& scene = findScene(GetParam().scene);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    EXPECT_LE(errorSeen(scene, randomTransform(seed, scene.fixedBalls, 1000)), GetParam().away)
        << seed;
}

// Balls in a row whose line is kept to the last bit: only then are hundreds of hits between convex
// surfaces, each of which magnifies what is across the line, those of the answer.
TEST(InvarianceOfRows, TurnedByQuartersMirroredShuffled) {
  for (const char* name : {"cradle", "galperin", "collapse-twin"}) {
    const Scene& scene = findScene(name);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
      EXPECT_LE(errorSeen(scene, exactTransform(seed, scene.fixedBalls)), 1e-9) << name << seed;
  }
}

// Turned by any angle, where hits are few.
TEST(InvarianceOfRows, TurnedMirroredShuffled) {
  for (const char* name : {"cradle", "collapse-twin"}) {
    const Scene& scene = findScene(name);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
      EXPECT_LE(errorSeen(scene, randomTransform(seed, scene.fixedBalls, 0)), 1e-9) << name << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Invariance, testing::ValuesIn(kBounds), [](const auto& bound) {
  std::string name = bound.param.scene;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace wells
