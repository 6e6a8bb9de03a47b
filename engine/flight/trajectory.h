// The path of one ball within a step, from its last event on: dense output, and bounds on how much
// the path bends.
#pragma once

#include "flight/integrators.h"

namespace wells {

/// What all balls of a step share.
struct FlightModel {
  const Field* field = nullptr;
  const Integrator* integrator = nullptr;
  double drag = 1;  // velocity factor per second
};

/// A ball that had `state` at `start` (s since the start of the step) and flies since.
struct Trajectory {
  BallState state;
  double start = 0;
};

/// The state at t >= start: one stretch of the integrator from `start`, so that a path has the
/// integrator's order whatever time it is asked for.
BallState stateAt(const FlightModel& model, const Trajectory& path, double t);

/// Bound (m/s^2) on the acceleration by wells and drag of a ball that now has `position` and
/// `velocity`, during the next `duration` seconds; gravity is not in it. Rigorous for the true
/// flight: a well of strength S and softening e pulls at most 2 S / (3 sqrt(3) e^2) and changes by
/// at most S / e^3 per metre. Exactly 0 without wells and drag.
double accelerationBound(const FlightModel& model, const BallState& ball, double t,
                         double duration);

}  // namespace wells
