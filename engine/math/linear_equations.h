// Dense linear equations, in plain loops: each entry is computed by the same operations in the same
// order whatever the instruction set, which Eigen's products do not promise. For systems of up to a
// few hundred unknowns.
#pragma once

#include <cstddef>
#include <span>

namespace wells {

/// Solves A x = b by Gaussian elimination with row pivoting. `matrix` holds A by rows and `b` the
/// right-hand side; x takes the place of b, and the matrix is used up. False: A is singular, or not
/// finite; b then holds anything.
bool solveLinear(std::span<double> matrix, std::span<double> b);

}  // namespace wells
