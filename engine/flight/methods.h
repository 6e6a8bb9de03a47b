// The integrators' functions, for their table alone; see integrators.h.
#pragma once

#include "flight/integrators.h"

namespace wells {

void flySymplecticEuler(const Flight&, const FlightArrays&);
void flyLeapfrog(const Flight&, const FlightArrays&);
void flyHeun(const Flight&, const FlightArrays&);
void flyRungeKutta4(const Flight&, const FlightArrays&);
void flyPefrl(const Flight&, const FlightArrays&);

}  // namespace wells
