// The custom integrator of the 2017 coursework report on distributed gravity wells, as published,
// weaknesses included, so that the other engines can be compared with it honestly. Not a solver to
// build on: "Known flaws" says why.
//
// A step of h (s): forces -> move every ball -> find all contacts -> resolve them together.
//
// Per ball: position p (m), velocity v (m/s), constant acceleration a (m/s^2: gravity), force F (N:
// wells, taken at the start of the step, and rolling resistance from the last detection), inverse
// mass w (1/kg), damping d (factor per second, Settings::drag), radius r (m). F = 0 after each
// step.
//
//   reference-euler           p += v h + a h^2/2;                  v += (a + F w) h;  v *= d^h
//   reference-improved-euler  p += (v + v_last) h/2 + a h^2/2;  v_last = v;
//                             v += (a + F w) h;  v *= d^h
//   reference-rk              stage(tau, k): p += k.v tau; v += k.a tau; return {v, F w}
//                             k1 = stage(0, 0); k2 = stage(h/2, k1); k3 = stage(h/2, k2);
//                             k4 = stage(h, k3); then p, v += h/6 (k1 + 2 (k2 + k3) + k4); v *= d.
//                             Gravity is part of F here, as m g.
// and, to show the difference, with the same contacts:
//   reference-heun            Heun's method (2nd order) as in textbooks, wells taken at both ends
//   reference-rk4             the classical Runge-Kutta method (4th order), wells at each stage
//
// Contacts, relative to the arena's centre: detection.h. Resolution, at most N times: take the
// contact with the most negative v_s = (v1 - v2).n, the first of equal ones, then those that
// overlap at v_s = 0; stop when there is none. v_s' = -e v_s; where a_s = (a1 - a2).n h < 0, add e
// a_s and make v_s' 0 if it is below 0.1 m/s. Impulse (v_s' - v_s)/(w1 + w2) along n. Then move
// both balls apart by their penetration, shared by inverse mass. No friction impulse; spin is left
// as it is.
//
// Known flaws, each shown by a test in tests/reference:
//   - Euler: the force does not enter the position.
//   - Improved Euler averages the current and the previous step's velocity and adds a h^2/2 on top:
//     it is not Heun's method, and of first order.
//   - Runge-Kutta moves the ball itself at each stage: by about 3 h in a step of h, at any h, so it
//     does not converge; in free fall it gains m g^2 h^2 (9/2 - 25/12) of energy a step. Its
//     damping is d a step, whatever h is.
//   - Rolling resistance, -friction |m g| v, grows with speed (viscous, not Coulomb's).
//   - The wall's penetration forgets r: nothing pushes a ball back before its centre is outside.
//   - Each pair of balls is found twice.
//
// What the report leaves open, and is fixed here: contacts that overlap at v_s = 0 are resolved too
// (Millington's own loop takes every overlap), because a ball that counts as rolling has v_s = 0,
// and if nothing resolved its penetration, every resting ball would sink through the ground; v_last
// of a ball's first step is its v, and so is it, with F = 0, whenever its position or velocity was
// changed from outside, since nobody sends them along; the resolver uses a = gravity in all
// variants; a contact without positive penetration moves nothing (Millington); ghosts are moved and
// touched like any other ball.
//
// Meant for up to 1,000 balls; 10,000 take tenths of a second a step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "state/stepper.h"

namespace wells {

enum class ReferenceVariant { Euler, ImprovedEuler, RungeKutta, Heun, Rk4 };

struct ReferenceOptions {
  /// Contacts taken a step, at most; >= 0. Empty: twice the number of contacts in the manifold.
  std::optional<std::int64_t> iterations;
};

/// counts().contacts is the length of the manifold: pairs count twice.
std::unique_ptr<Stepper> makeReference(ReferenceVariant variant,
                                       const ReferenceOptions& options = {});

/// The variant with this name(), or nothing.
std::optional<ReferenceVariant> referenceVariant(std::string_view name);

/// All names, the published ones first.
std::vector<std::string_view> referenceNames();

}  // namespace wells
