#include "math/linear_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

TEST(LinearEquations, AgreeWithEigen) {
  Random random(1);
  for (const int n : {1, 2, 3, 10, 72}) {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Matrix matrix(n, n);
    Eigen::VectorXd b(n);
    for (int i = 0; i < n; ++i) {
      b[i] = random.uniform(-1, 1);
      // Half of it empty, so that pivots have to be looked for.
      for (int j = 0; j < n; ++j) matrix(i, j) = random.uniform() < 0.5 ? 0 : random.uniform(-1, 1);
      matrix(i, (i + 1) % n) += 3;
    }
    const Eigen::VectorXd expected = matrix.fullPivLu().solve(b);
    std::vector<double> entries(matrix.data(), matrix.data() + n * n);
    std::vector<double> x(b.data(), b.data() + n);
    ASSERT_TRUE(solveLinear(entries, x)) << n;
    for (int i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], expected[i], 1e-12);
  }
}

TEST(LinearEquations, SaysWhereThereIsNoSolution) {
  std::vector<double> matrix = {1, 2, 2, 4};
  std::vector<double> b = {1, 3};
  EXPECT_FALSE(solveLinear(matrix, b));
}

}  // namespace
}  // namespace wells
