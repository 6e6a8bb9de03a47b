// Contact detection of the custom integrator. Called in this order, the three functions fill the
// manifold in the report's order.
#pragma once

#include <span>

#include "reference/manifold.h"
#include "reference/touching_pairs.h"
#include "state/world.h"

namespace wells {

/// Below this speed (m/s) up or down, a ball that reaches into the ground counts as rolling.
inline constexpr double kRollingSpeed = 0.5;

/// Appends a contact for each ball with y < r, and applies the report's rolling rule to it: if also
/// |v_y| < kRollingSpeed, v_y = 0 and the force -friction |m g| v is added to `force` (N, by ball).
void detectGround(World& world, std::span<Vec3> force, Manifold& manifold);

/// Appends a contact for each ball with x^2 + z^2 >= (R - r)^2, relative to the arena's centre.
/// Its penetration, sqrt(x^2 + z^2) - R, is negative until the centre has passed the wall.
void detectWall(const World& world, Manifold& manifold);

/// Appends two contacts for each pair that touches: one as (i, j), one as (j, i). Coincident
/// centres have no direction; the ball with the lower id is then taken as the upper one.
void detectPairs(const World& world, TouchingPairs& pairs, Manifold& manifold);

}  // namespace wells
