#include "math/components.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "math/instruction_set.h"
#include "math/random.h"

namespace wells {
namespace {

class Components : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override { useInstructionSet(GetParam()); }
  void TearDown() override { useInstructionSet(instructionSets().back()); }
};

TEST_P(Components, AreThoseOfTheVectorsNamedAndGoBackThere) {
  Random random(1);
  std::vector<Vec3> vectors;
  for (int i = 0; i < 100; ++i) vectors.push_back(random.direction());
  const std::vector<std::vector<std::uint32_t>> lists = {
      {},
      {99},
      {7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19},
      {7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 19, 18, 20},
      {5, 3, 4, 1, 0, 60, 61, 62}};
  for (const auto& ids : lists) {
    std::vector<double> x(ids.size()), y(ids.size()), z(ids.size());
    toComponents(ids, vectors.data(), x.data(), y.data(), z.data());
    std::vector<Vec3> back(vectors.size(), Vec3::Zero());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      EXPECT_EQ(Vec3(x[k], y[k], z[k]), vectors[ids[k]]);
      back[ids[k]].setOnes();
    }
    const std::vector<Vec3> named = back;
    fromComponents(ids, x.data(), y.data(), z.data(), back.data());
    for (std::size_t i = 0; i < vectors.size(); ++i)
      EXPECT_EQ(back[i], named[i] == Vec3::Ones() ? vectors[i] : Vec3::Zero()) << i;
  }
}

TEST_P(Components, WhatIsNotFiniteIsFoundWhereverItIs) {
  for (const std::size_t size : {1, 2, 7, 8, 9, 1030}) {
    std::vector<double> numbers(size, std::numeric_limits<double>::max());
    EXPECT_TRUE(areFinite(numbers));
    for (const std::size_t at : {std::size_t{0}, size / 2, size - 1})
      for (const double wrong :
           {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
        std::vector<double> spoilt = numbers;
        spoilt[at] = wrong;
        EXPECT_FALSE(areFinite(spoilt)) << size << ", " << at;
      }
  }
  EXPECT_TRUE(areFinite({}));
}

INSTANTIATE_TEST_SUITE_P(Sets, Components, testing::ValuesIn(instructionSets()),
                         [](const auto& tested) { return std::string(name(tested.param)); });

}  // namespace
}  // namespace wells
