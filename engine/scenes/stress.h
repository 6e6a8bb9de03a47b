// Worlds that break engines: fast balls, coarse steps, balls that start inside each other, sharp
// wells, extreme ratios, numbers that are none. What must hold in them stands in stress_cases.h.
//
// Most come in several versions, counted from 0; `about` says what is special about each. Balls are
// of radius 0.5 m and 1 kg, gravity is standard, dt is 1/60 s and the arena that of a plain World
// unless said.
#pragma once

#include <cstddef>
#include <string>

#include "state/world.h"

namespace wells {

struct StressWorld {
  std::string about;    // what is special about this version
  World world;          // at the start
  double pushOut = 0;   // J, what pushing balls out of the start's overlaps may add
  std::size_t bad = 0;  // so many of the last balls have a state that is not finite
};

/// 10^4 m/s, dt = 0.1 s: straight and oblique, e = 1 and 0.5, mu = 0 and 0.3. 8 versions each.
StressWorld makeFastAtWall(int version);
StressWorld makeFastAtGround(int version);
StressWorld makeFastAtBall(int version);

/// T1 with 1,000 balls at the given step (s).
StressWorld makeCoarseHeaps(double dt);

/// Without gravity: two balls, half and wholly inside each other, at rest and moving. 6 versions.
StressWorld makeOverlappingPair(int version);

/// 27 balls in one point, and half inside each other on a lattice. 4 versions.
StressWorld makeOverlappingClump(int version);

/// One ball half and wholly inside the ground, the wall and both. 6 versions.
StressWorld makeInsideArena(int version);

/// No gravity; a well of softening 0.01 m, S = 100 m^3/s^2, and balls that fall into it from rest
/// at 10 m: one head-on, one nearly, two from both sides at e = 1 and 0.8. 4 versions.
StressWorld makeSharpWell(int version);

/// T2 with 1,000 balls and e = 0.05: balls gather in clusters. mu = 0 and 0.3: 2 versions.
StressWorld makeCollapsingGas(int version);

/// Stacks of touching balls, e = 0.5: 10^6 kg on 1 kg; 10^6 on 10^3 on 1 kg; 1 kg on 10^6 kg. 3
/// versions.
StressWorld makeMassRatio(int version);

/// A ball of 5 m and 1000 kg falls on nine of 0.05 m and 1 g.
StressWorld makeRadiusRatio();

/// 25 balls spread over the ground, and wells: two at one point; one that jumps 100 m within a step
/// and, a second later, back; one that repels. 3 versions.
StressWorld makeOddWells(int version);

/// Without gravity, e = 1, mu = 0: a square lattice of 100 balls that touch exactly, hit by an
/// 101st at 10 m/s, head-on to a row and between two rows. 2 versions.
StressWorld makeTouchingLattice(int version);

/// A ball that touches ground and wall and spins at 100 rad/s: about the wall's normal, upwards and
/// along the wall, mu = 0.3 and 1. 6 versions.
StressWorld makeCornerSpin(int version);

/// 25 balls that start with up to 5 m/s; the arena's centre is (10^6, 0, -10^6) m.
StressWorld makeFarAway();

/// The same at the origin with a step of 1e-6, 1e-4, 1e-2, 0.1 and 1 s. 5 versions.
StressWorld makeAnyStep(int version);

/// The same with a 26th ball: NaN or infinity in its position, velocity or spin. 6 versions.
StressWorld makeNotFinite(int version);

}  // namespace wells
