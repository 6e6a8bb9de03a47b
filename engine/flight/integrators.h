// How a ball moves between contacts: integrators as values in a table.
#pragma once

#include <cstddef>
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

/// Positions (m) and velocities (m/s) of `count` balls, an array a component, of any alignment.
struct FlightArrays {
  double* x;
  double* y;
  double* z;
  double* vx;
  double* vy;
  double* vz;
  std::size_t count;
};

/// An integrator advances balls by one stretch. Steps go through flyThrough().
struct Integrator {
  std::string_view name;
  std::string_view about;
  int order;        // of the global error, without drag
  int evaluations;  // of the field for one ball and flight
  bool isDense;     // in a flight of any duration velocity is the rate of position, to its order;
                    // what finding impact times within a step asks for
  void (*fly)(const Flight&, const FlightArrays& balls);
};

/// Flies all balls through the whole duration: exactly where nothing but gravity acts, whatever the
/// integrator; else in stretches of field.stretch, the last one shorter. A ball has the same bits
/// whatever balls fly beside it, and on every instruction set.
void flyThrough(const Integrator& integrator, const Flight& flight, const FlightArrays& balls);

/// The same for the balls named by `balls`.
void flyThrough(const Integrator& integrator, const Flight& flight,
                std::span<const std::uint32_t> balls, Vec3* position, Vec3* velocity);

/// A remainder this small, in stretches, is rounding and belongs to the stretch before it.
inline constexpr double kNoRemainder = 1e-9;

/// True where nothing but gravity acts.
inline bool isParabola(const Field& field, double drag) {
  return field.wells.empty() && drag == 1;
}

/// True where velocity is the rate of position at all times within a flight.
inline bool isDenseIn(const Integrator& integrator, const Field& field, double drag) {
  return integrator.isDense || isParabola(field, drag);
}

std::span<const Integrator> integrators();

/// The integrator of that name, or throws std::invalid_argument with the names that exist.
const Integrator& findIntegrator(std::string_view name);

}  // namespace wells
