// Heaps about wells: they come to rest, stay where they are, and contacts add no energy on the way.
// (T1, for which there is no exact answer; what is held here must be so in any heap.)

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/crowds.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr std::size_t kBalls = 250;

double furthest(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double most = 0;
  for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, length(to[i] - from[i]));
  return most;
}

// Nothing but contacts brings them to rest: nothing sleeps. What is left is that the pull varies
// over the 0.1 mm by which a ball falls and is lifted again in a substep: 1e-21 J. Now and then
// that opens a contact, and one ball moves for a moment, at less than a micrometre a second.
TEST(Heaps, ComeToRestAndDoNotCreep) {
  for (const std::uint64_t seed : {1, 2, 4}) {
    World world = makeWellsCrowd(kBalls, seed);
    world.settings.sleepSpeed = 0;
    const auto simulation = makeSimulation();
    while (world.time() < 15) simulation->step(world);
    EXPECT_LE(kineticEnergy(world.balls), 1e-12) << seed;
    const std::vector<Vec3> before = world.balls.position;
    for (int step = 0; step < 2000; ++step) simulation->step(world);
    EXPECT_LE(furthest(before, world.balls.position), 1e-4) << seed;
    EXPECT_LE(kineticEnergy(world.balls), 1e-12) << seed;
    EXPECT_LE(measure(world).worstOverlap(), 1e-3) << seed;
  }
}

TEST(Heaps, FallAsleepAsAWhole) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    World world = makeWellsCrowd(kBalls, seed);
    const auto simulation = makeSimulation();
    while (world.time() < 30 && simulation->counts().asleep < std::int64_t{kBalls})
      simulation->step(world);
    EXPECT_EQ(simulation->counts().asleep, std::int64_t{kBalls}) << seed;
    EXPECT_EQ(kineticEnergy(world.balls), 0) << seed;
    EXPECT_LE(measure(world).worstOverlap(), 1e-3) << seed;
  }
}

// Energies are those of -8e3 J in the wells; what a heap that slides slowly gains by forces along
// normals that turn is the hardest part.
TEST(Heaps, GainNoEnergyByContactsInAnyStep) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    World world = makeWellsCrowd(kBalls, seed);
    const double bound = 1e-10 * std::abs(measure(world).energy());
    const auto simulation = makeSimulation();
    simulation->openBooks();
    double before = 0;
    while (world.time() < 10) {
      simulation->step(world);
      const double now = simulation->books()->contacts + simulation->books()->friction;
      ASSERT_LE(now - before, bound) << "seed " << seed << ", step " << world.step;
      before = now;
    }
  }
}

}  // namespace
}  // namespace wells
