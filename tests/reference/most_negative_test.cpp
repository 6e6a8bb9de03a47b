#include "reference/most_negative.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/random.h"

namespace wells {
namespace {

std::uint32_t scan(const std::vector<double>& values) {
  std::uint32_t best = MostNegative::kNone;
  double smallest = 0;
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (values[i] < smallest) {
      smallest = values[i];
      best = i;
    }
  }
  return best;
}

TEST(MostNegative, EqualsAScanWhateverChanges) {
  Random random(7);
  MostNegative tree;
  for (const std::size_t count : {1u, 2u, 3u, 7u, 8u, 9u, 100u}) {
    std::vector<double> values(count);
    // Few distinct values, so that the first of equal ones matters; one of them no number.
    const auto draw = [&] {
      const double value = static_cast<double>(random.below(7)) - 3;
      return value == 3 ? std::numeric_limits<double>::quiet_NaN() : value;
    };
    for (double& value : values) value = draw();
    tree.assign(values);
    EXPECT_EQ(tree.first(), scan(values));
    for (int change = 0; change < 1000; ++change) {
      const std::size_t i = random.below(count);
      values[i] = draw();
      tree.set(i, values[i]);
      ASSERT_EQ(tree.first(), scan(values)) << count << " numbers, change " << change;
    }
  }
}

TEST(MostNegative, NothingBelowZeroIsNone) {
  MostNegative tree;
  EXPECT_EQ(tree.first(), MostNegative::kNone);
  tree.assign(std::vector<double>{});
  EXPECT_EQ(tree.first(), MostNegative::kNone);
  tree.assign(std::vector<double>{0.0, 1.0, -0.0});
  EXPECT_EQ(tree.first(), MostNegative::kNone);
}

}  // namespace
}  // namespace wells
