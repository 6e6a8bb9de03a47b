// Where the energy and the momentum of the balls went, by source, since the books were opened. Data
// only; engines that can keep books fill them in.
//
// Energy is kinetic and potential, as measures.h has it. The books close,
//   energy now - energy at the start = energy()
// and momentum and angular momentum likewise, to rounding: entries are measured where they arise,
// and the one that is a remainder, flight, is that of each stretch of a ball's path. Ghosts that
// drift because they touch ghosts are booked as changes from outside, with what becomes of a ball
// whose state stops being finite.
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
  // Contacts, and contacts and friction together, add nothing beyond rounding, unless substeps are
  // too few for the world (see tests/stress).
  double contacts = 0;  // normal impulses, and positions shifted by lasting ones: restitution
  double friction = 0;  // tangent impulses, sliding, and rolling resistance
  double drag = 0;      // never > 0
  double wells = 0;     // wells that move, and fields that are switched or change their strength
  double pushOut = 0;   // potential energy that correcting positions changed: pushing out overlaps
  double flight = 0;    // residual of the integrator: falls with its order
  double sleep = 0;     // what was left of the motion of balls that fell asleep; never > 0
  double outside = 0;   // states that were changed between two steps

  ImpulseBook ground;
  ImpulseBook wall;
  ImpulseBook fields;   // gravity, wells and drag
  ImpulseBook shifts;   // overlaps, and positions that a solver corrected: angular only
  ImpulseBook rest;     // what was left of the motion of balls that fell asleep
  ImpulseBook changes;  // states that were changed between two steps

  double energy() const {
    return contacts + friction + drag + wells + pushOut + flight + sleep + outside;
  }
  Vec3 impulse() const {
    return ground.linear + wall.linear + fields.linear + rest.linear + changes.linear;
  }
  Vec3 angularImpulse() const {
    return ground.angular + wall.angular + fields.angular + shifts.angular + rest.angular +
           changes.angular;
  }

  Books& operator+=(const Books& more);
};

}  // namespace wells
