// What a step needs to know besides the state: physics and method. Part of the world, the same for
// all peers of a session.
#pragma once

#include <string>

#include "math/vector.h"

namespace wells {

/// How contacts are resolved.
///   Substep  all by sequential impulses at the end of substeps; first order through impacts
///   Exact    impacts at their own times within the step, in the integrator's order; islands in
///   which
///            a contact lasts are left to the substeps
enum class ContactMethod { Substep, Exact };

struct Settings {
  // Physics.
  double dt = 1.0 / 60;              // s, > 0; one step
  Vec3 gravity = Vec3{0, -9.81, 0};  // m/s^2; zero for none
  double drag = 1;                   // velocity factor per second, in (0, 1]; 1: none
  double elasticity = 0.8;           // coefficient of restitution, 0 .. 1
  double friction = 0.3;             // Coulomb's coefficient, >= 0

  // Method.
  std::string integrator = "leapfrog";  // a name of flight/integrators.h
  ContactMethod contactMethod = ContactMethod::Exact;
  int substeps = 4;    // of a ball that may touch something, >= 1
  int iterations = 4;  // solver passes a substep, >= 1
};

}  // namespace wells
