#include "search/numbering.h"

#include <gtest/gtest.h>

#include <map>

#include "math/random.h"

namespace wells {
namespace {

TEST(Numbering, EqualThingsHaveEqualNumbersInTheOrderOfTheirComing) {
  Numbering<std::array<std::uint32_t, 3>> numbering;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> reference;
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const std::array item{static_cast<std::uint32_t>(random.below(40)),
                          static_cast<std::uint32_t>(random.below(40)),
                          static_cast<std::uint32_t>(random.below(40))};
    const auto next = static_cast<std::uint32_t>(reference.size() + 1);
    const std::uint32_t expected = reference.try_emplace(item, next).first->second;
    ASSERT_EQ(numbering.number(item), expected);
    ASSERT_EQ(numbering[expected], item);
  }
  EXPECT_EQ(numbering.size(), reference.size());
}

TEST(Numbering, RowsOfDifferentLengthDiffer) {
  RowNumbering numbering;
  std::map<std::vector<std::uint16_t>, std::uint32_t> reference;
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    std::vector<std::uint16_t> row(random.below(6));
    for (auto& word : row) word = static_cast<std::uint16_t>(random.below(7));
    const auto next = static_cast<std::uint32_t>(reference.size() + 1);
    const std::uint32_t expected = reference.try_emplace(row, next).first->second;
    ASSERT_EQ(numbering.number(row), expected);
    const auto kept = numbering[expected];
    ASSERT_TRUE(std::equal(kept.begin(), kept.end(), row.begin(), row.end()));
  }
  EXPECT_EQ(numbering.size(), reference.size());
}

// The hash only says where to look.
TEST(Numbering, ThingsWithTheSameHashAreToldApart) {
  HashIndex index;
  std::vector<int> things;
  for (int thing = 0; thing < 2000; ++thing) {
    const auto next = static_cast<std::uint32_t>(things.size() + 1);
    const auto find = [&] {
      return index.findOrAdd(42, next, [&](std::uint32_t n) { return things[n - 1] == thing; });
    };
    ASSERT_EQ(find(), next);
    things.push_back(thing);
    ASSERT_EQ(find(), next);
  }
}

}  // namespace
}  // namespace wells
