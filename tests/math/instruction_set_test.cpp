#include "math/instruction_set.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace wells {
namespace {

TEST(InstructionSet, TheBestOneIsInUseUnlessToldOtherwise) {
  const auto sets = instructionSets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front(), InstructionSet::Baseline);
  EXPECT_EQ(instructionSet(), sets.back());
  useInstructionSet(InstructionSet::Baseline);
  EXPECT_EQ(instructionSet(), InstructionSet::Baseline);
  useInstructionSet(sets.back());
}

TEST(InstructionSet, HasANameThatFindsIt) {
  for (const InstructionSet set :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
    EXPECT_EQ(findInstructionSet(name(set)), set);
  try {
    findInstructionSet("mmx");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "instruction set 'mmx' is unknown; allowed: baseline, avx2, avx512");
  }
}

TEST(InstructionSet, OneThatTheProcessorHasNotIsRefused) {
  const auto sets = instructionSets();
  if (sets.back() == InstructionSet::Avx512) GTEST_SKIP() << "this processor has them all";
  EXPECT_THROW(useInstructionSet(InstructionSet::Avx512), std::invalid_argument);
  EXPECT_EQ(instructionSet(), sets.back());
}

}  // namespace
}  // namespace wells
