// The path of one ball within a step, from its last event on: in flight, or held by the ground, the
// wall or both, on which it rolls or slides. Dense output, and bounds on how much the path bends.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "contacts/contact.h"
#include "flight/integrators.h"

namespace wells {

/// What all balls of a step share.
struct PathModel {
  const Field* field = nullptr;
  const Integrator* integrator = nullptr;
  const Arena* arena = nullptr;
  double drag = 1;               // velocity factor per second
  double friction = 0;           // Coulomb's coefficient
  double rollingResistance = 0;  // m
};

enum class Motion : std::uint8_t {
  Flying,
  Rolling,   // on a surface, without slip; in the corner, on both
  Sliding,   // on a surface; in the corner, on at least one
  Skidding,  // slides, and rolling resistance keeps it from turning
  Resting    // friction and rolling resistance hold it
};

/// In the place of kGround or kWall: none, and both at once.
inline constexpr std::uint32_t kNoSurface = 0;
inline constexpr std::uint32_t kCorner = 1;

/// A ball that had `state` at `start` (s since the start of the step) and moves on since.
struct Path {
  BallState state;
  double start = 0;   // s
  double radius = 0;  // m
  Motion motion = Motion::Flying;
  std::uint32_t surface = kNoSurface;  // that holds a ball that does not fly
  std::uint32_t rolling = kNoSurface;  // in the corner: on which it rolls
};

/// The path that begins with `state` at time t. Where the ball touches the ground or the wall (or
/// both), does not leave it and is pressed to it, that surface holds it: its distance, its velocity
/// towards it and, if it rolls, its spin are then made exact. What rests stays as it is, to the
/// bit.
Path pathFrom(const PathModel& model, const BallState& state, double radius, double t);

/// The state at t >= path.start: one flight, or one integration of the held ball,
/// from `start`, so that a path has its method's order whatever time it is asked for.
BallState stateAt(const PathModel& model, const Path& path, double t);

/// Both at the same time, to the same bits: flights that begin together cost little more than one.
std::pair<BallState, BallState> statesAt(const PathModel& model, const Path& a, const Path& b,
                                         double t);

/// Sets the states in `balls` of those named, each on paths[place[its id]] in flight and set out
/// before t, to those at time t: stateAt() of many, of which those that set out together fly
/// together. Sorts `flying` by when they did.
void endFlights(const PathModel& model, std::span<const Path> paths,
                std::span<const std::uint32_t> place, double t, std::span<std::uint32_t> flying,
                Balls& balls);

/// Bound (m/s^2) on the acceleration of a ball that has state `now` on the path at time t, during
/// the next `duration` seconds. In flight by wells and drag alone; gravity is not in it. Held by a
/// surface, whatever the source. Rigorous for the true path: a well of strength S and softening e
/// pulls by S r / (r^2 + e^2)^(3/2) at the distance r, most at r = e / sqrt(2). Exactly 0 without
/// wells and drag in flight and on the level ground where nothing slides.
double accelerationBound(const PathModel& model, const Path& path, const BallState& now, double t,
                         double duration);

/// Bound (m/s^2) on how fast the closing speed of two balls can grow, beside what the turning of
/// their line of centres does.
double approachBound(const PathModel& model, const Path& pathA, const BallState& a,
                     const Path& pathB, const BallState& b, double t, double duration);

}  // namespace wells
