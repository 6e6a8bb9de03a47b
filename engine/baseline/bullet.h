// Stock Bullet as a baseline: a btDiscreteDynamicsWorld with Bullet's own default settings, in
// single precision (Debian's standard build, what a user would pick), on the same World as the
// other engines. Nothing in it is tuned, so that comparisons are with Bullet as it comes.
//
// Everything is relative to the arena's centre, which keeps single precision where the balls are.
//   balls    btSphereShape, mass and moment of inertia of a solid sphere; ghosts like any other
//   ground   btStaticPlaneShape
//   wall     64 boxes whose inner faces are tangent to the cylinder of radius R, a regular polygon:
//            between two of them a centre reaches out to (R - r) / cos(pi / 64). As high as R plus
//            the highest ball at the start; what flies higher can leave.
//   gravity  Bullet's; wells as a central force, taken at the start of the step
//   e, mu    Bullet multiplies the coefficients of the two bodies: every body has sqrt(e), sqrt(mu)
//   drag     Bullet's linear damping 1 - d, which it applies as d^dt; spin is not damped
// One step is stepSimulation(dt, 0): one internal step of dt, single-threaded.
//
// An executable that links this must not link Bullet in double precision: the symbols are the same.
#pragma once

#include <memory>

#include "state/stepper.h"

namespace wells {

/// Bullet puts bodies to sleep that stay slower than 0.8 m/s and 1 rad/s for 2 s. Asleep they feel
/// no well until something touches them or changes them from outside.
enum class BulletSleeping { Off, On };

struct BulletOptions {
  BulletSleeping sleeping = BulletSleeping::Off;
};

/// A ball whose state in the World is not what the last step left there is taken up as it stands.
/// A change of arena, radii, masses or number of balls starts Bullet's world afresh.
/// counts(): overlapping boxes, and points in Bullet's manifolds; latePairs is not known: 0.
std::unique_ptr<Stepper> makeBullet(const BulletOptions& options = {});

}  // namespace wells
