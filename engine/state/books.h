// Where the energy and the momentum of the owned balls went, by source, since the books were
// opened. Data only; engines that can keep books fill them in.
//
// Energy is kinetic and potential, as measures.h has it. The books close:
//   energy now - energy at the start = energy()        momentum likewise = impulse()
// to rounding, because each entry is measured where it arises and no entry is a remainder of the
// others, but for `flight`, which is what a stretch of flight changed and neither drag nor wells
// explain.
#pragma once

#include "math/vector.h"

namespace wells {

/// What one partner gave the balls.
struct ImpulseBook {
  Vec3 linear = Vec3::Zero();   // N s
  Vec3 angular = Vec3::Zero();  // kg m^2/s about the arena's centre, on orbit and spin together
};

struct Books {
  // J, added to the balls; < 0: taken from them.
  double contacts = 0;  // normal impulses and what they shift: restitution; never > 0
  double friction = 0;  // tangent impulses; never > 0
  double drag = 0;      // never > 0
  double wells = 0;     // wells that move, switch on or off, or change their strength
  double pushOut = 0;   // potential energy that pushing out of overlaps changed
  double flight = 0;    // residual: falls with the integrator's order
  double outside = 0;   // states or settings that were changed between two steps

  ImpulseBook ground;
  ImpulseBook wall;
  ImpulseBook ghosts;  // balls that other peers own
  ImpulseBook fields;  // gravity, wells and drag
  ImpulseBook outsideImpulse;

  double energy() const { return contacts + friction + drag + wells + pushOut + flight + outside; }
  Vec3 impulse() const {
    return ground.linear + wall.linear + ghosts.linear + fields.linear + outsideImpulse.linear;
  }
  Vec3 angularImpulse() const {
    return ground.angular + wall.angular + ghosts.angular + fields.angular + outsideImpulse.angular;
  }
};

}  // namespace wells
