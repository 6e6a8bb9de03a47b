// How a ball moves between contacts: integrators as values in a table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "forces/field.h"
#include "state/balls.h"

namespace wells {

/// One stretch of flight: all balls of it share the field and the times.
struct Flight {
  const Field* field;  // must outlive the flight
  double start;        // s since the start of the step at which the field's wells stand
  double duration;     // s, > 0
  double drag;         // velocity factor per second, in (0, 1]
};

/// An integrator advances position (m) and velocity (m/s) of the balls named by `balls`.
struct Integrator {
  std::string_view name;
  std::string_view about;
  int order;        // of the global error, without drag
  int evaluations;  // of the field for one ball and flight
  bool isDense;     // in a flight of any duration velocity is the rate of position, to its order;
                    // what finding impact times within a step asks for
  void (*fly)(const Flight&, std::span<const std::uint32_t> balls, Vec3* position, Vec3* velocity);
};

std::span<const Integrator> integrators();

/// The integrator of that name, or throws std::invalid_argument with the names that exist.
const Integrator& findIntegrator(std::string_view name);

}  // namespace wells
