#include "scenes/stress_cases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <vector>

namespace wells {
namespace {

constexpr StressCase kCases[] = {
    {.name = "fast-wall",
     .about = "10^4 m/s at the wall, dt = 0.1 s",
     .versions = 8,
     .make = makeFastAtWall,
     .steps = 20},
    {.name = "fast-ground",
     .about = "10^4 m/s at the ground, dt = 0.1 s",
     .versions = 8,
     .make = makeFastAtGround,
     .steps = 20},
    {.name = "fast-ball",
     .about = "10^4 m/s at another ball, dt = 0.1 s",
     .versions = 8,
     .make = makeFastAtBall,
     .steps = 20},
    {.name = "heaps-coarse",
     .about = "1,000 balls fall and collapse onto four wells, dt = 1/6 s",
     .versions = 1,
     .make = [](int) { return makeCoarseHeaps(1.0 / 6); },
     .steps = 60,
     .energy = EnergyPromise::Pressed},
    {.name = "heaps-alternating",
     .about = "the same with dt = 1/60 s and 1/6 s in turn",
     .versions = 1,
     .make = [](int) { return makeCoarseHeaps(1.0 / 60); },
     .steps = 120,
     .secondDt = 1.0 / 6,
     .energy = EnergyPromise::Pressed},
    {.name = "overlap-pair",
     .about = "two balls start inside each other, no gravity",
     .versions = 6,
     .make = makeOverlappingPair,
     .steps = 120,
     .apart = 60},
    {.name = "overlap-clump",
     .about = "27 balls start inside each other",
     .versions = 4,
     .make = makeOverlappingClump,
     .steps = 300,
     .apart = 180,
     .energy = EnergyPromise::Pressed},
    {.name = "overlap-arena",
     .about = "a ball starts inside ground or wall",
     .versions = 6,
     .make = makeInsideArena,
     .steps = 120,
     .apart = 60},
    {.name = "sharp-well",
     .about = "balls fall from 10 m into a well of softening 0.01 m",
     .versions = 4,
     .make = makeSharpWell,
     .steps = 600,
     .energy = EnergyPromise::Pressed},
    {.name = "collapsing-gas",
     .about = "1,000 balls, e = 0.05, no gravity: clusters",
     .versions = 2,
     .make = makeCollapsingGas,
     .steps = 600},
    {.name = "mass-ratio",
     .about = "stacks with 10^6 kg on 1 kg",
     .versions = 3,
     .make = makeMassRatio,
     .steps = 300,
     .energy = EnergyPromise::Pressed},
    {.name = "radius-ratio",
     .about = "a ball of 5 m falls on nine of 0.05 m",
     .versions = 1,
     .make = [](int) { return makeRadiusRatio(); },
     .steps = 300,
     .energy = EnergyPromise::Pressed},
    {.name = "wells-at-rest",
     .about = "two wells at one point; a well that repels",
     .versions = 2,
     .make = [](int version) { return makeOddWells(2 * version); },
     .steps = 600,
     .energy = EnergyPromise::Pressed},
    {.name = "well-jumps",
     .about = "a well jumps 100 m within a step",
     .versions = 1,
     .make = [](int) { return makeOddWells(1); },
     .steps = 600,
     .energy = EnergyPromise::WellsMove},
    {.name = "touching-lattice",
     .about = "100 balls that touch exactly are hit at 10 m/s, e = 1",
     .versions = 2,
     .make = makeTouchingLattice,
     .steps = 300},
    {.name = "corner-spin",
     .about = "a ball spins at 100 rad/s in the corner of ground and wall",
     .versions = 6,
     .make = makeCornerSpin,
     .steps = 300,
     .energy = EnergyPromise::Pressed},
    {.name = "far-away",
     .about = "25 balls, 10^6 m from the origin",
     .versions = 1,
     .make = [](int) { return makeFarAway(); },
     .steps = 600},
    {.name = "any-step",
     .about = "25 balls, dt from 1e-6 s to 1 s",
     .versions = 5,
     .make = makeAnyStep,
     .steps = 300,
     .energy = EnergyPromise::Pressed},
    {.name = "not-finite",
     .about = "NaN or infinity in one of 26 balls",
     .versions = 6,
     .make = makeNotFinite,
     .steps = 120},
};

}  // namespace

std::span<const StressCase> stressCases() {
  return kCases;
}

const StressCase& findStressCase(std::string_view name) {
  for (const StressCase& stress : kCases)
    if (stress.name == name) return stress;
  std::vector<std::string_view> names;
  for (const StressCase& stress : kCases) names.push_back(stress.name);
  throw std::invalid_argument(
      fmt::format("stress case '{}' is unknown; allowed: {}", name, fmt::join(names, ", ")));
}

void setDt(const StressCase& stress, const World& start, World& world) {
  if (stress.secondDt != 0)
    world.settings.dt = world.step % 2 == 0 ? start.settings.dt : stress.secondDt;
}

}  // namespace wells
