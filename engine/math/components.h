// Vectors as Vec3 has them, and with an array for each component, as vector code wants them: copies
// from one to the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "math/vector.h"

namespace wells {

/// x[k], y[k], z[k] become the components of vectors[ids[k]]. Quickest where the ids follow each
/// other.
void toComponents(std::span<const std::uint32_t> ids, const Vec3* vectors, double* x, double* y,
                  double* z);

/// The other way.
void fromComponents(std::span<const std::uint32_t> ids, const double* x, const double* y,
                    const double* z, Vec3* vectors);

/// True when none of the numbers is NaN or infinite.
bool areFinite(std::span<const double> numbers);

}  // namespace wells
