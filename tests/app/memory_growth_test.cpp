// Memory of which the test knows how much it is.

#include "memory_growth.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace wells {
namespace {

constexpr std::size_t kSize = 64;                   // MiB
constexpr std::size_t kMiB = std::size_t{1} << 20;  // bytes

TEST(MemoryGrowth, CountsWhatWasThereAtOnce) {
  const MemoryGrowth growth;
  for (int time = 0; time < 3; ++time) {
    const std::vector<char> used(kSize * kMiB, 1);
    ASSERT_EQ(used.back(), 1);
  }
  EXPECT_GE(growth.most(), kSize);
}

TEST(MemoryGrowth, LeavesOutWhatWasThereBefore) {
  const std::vector<char> kept(kSize * kMiB, 1);
  { const std::vector<char> gone(kSize * kMiB, 1); }
  const MemoryGrowth growth;
  EXPECT_LT(growth.most(), kSize / 2);
  EXPECT_EQ(kept.back(), 1);
}

/// Pages that nobody has touched take no memory.
TEST(MemoryGrowth, LeavesOutWhatIsNotUsed) {
  const MemoryGrowth growth;
  std::vector<char> reserved;
  reserved.reserve(kSize * kMiB);
  EXPECT_LT(growth.most(), kSize / 2);
}

}  // namespace
}  // namespace wells
