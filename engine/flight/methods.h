// The integrators' functions, for their table alone; see integrators.h.
#pragma once

#include "flight/integrators.h"

namespace wells {

void flySymplecticEuler(const Flight&, std::span<const std::uint32_t>, Vec3*, Vec3*);
void flyLeapfrog(const Flight&, std::span<const std::uint32_t>, Vec3*, Vec3*);
void flyHeun(const Flight&, std::span<const std::uint32_t>, Vec3*, Vec3*);
void flyRungeKutta4(const Flight&, std::span<const std::uint32_t>, Vec3*, Vec3*);
void flyPefrl(const Flight&, std::span<const std::uint32_t>, Vec3*, Vec3*);

}  // namespace wells
