// The integrators of the custom engine, one file each: the three of the report as it published
// them, and the textbook methods that two of them are named after. reference.h has the formulas.
//
// Each advances one ball by one step of h, and leaves its force accumulator at zero.
#pragma once

#include "reference/ball.h"

namespace wells {

/// Published. The force does not enter the position.
void advanceEuler(const ReferenceStep& step, ReferenceBall& ball);

/// Published. Averages the velocity with the previous step's; not Heun's method.
void advanceImprovedEuler(const ReferenceStep& step, ReferenceBall& ball);

/// Published. Its stages move the ball itself. Gravity is a force here.
void advanceRungeKutta(const ReferenceStep& step, ReferenceBall& ball);

/// Textbook, 2nd order.
void advanceHeun(const ReferenceStep& step, ReferenceBall& ball);

/// Textbook, 4th order.
void advanceRk4(const ReferenceStep& step, ReferenceBall& ball);

}  // namespace wells
