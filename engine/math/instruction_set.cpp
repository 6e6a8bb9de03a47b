#include "math/instruction_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <hwy/highway.h>
#include <stdexcept>

#include "math/find_by_name.h"

namespace wells {
namespace {

struct Target {
  InstructionSet set;
  std::string_view name;
  std::int64_t bit;  // Highway's
};

constexpr Target kTargets[] = {{InstructionSet::Baseline, "baseline", HWY_SCALAR},
                               {InstructionSet::Avx2, "avx2", HWY_AVX2},
                               {InstructionSet::Avx512, "avx512", HWY_AVX3}};

constexpr std::int64_t kCompiled = HWY_SCALAR | HWY_AVX2 | HWY_AVX3;
static_assert(HWY_TARGETS == kCompiled, "Highway compiles for other targets than kTargets");

const Target& targetOf(InstructionSet set) {
  return kTargets[static_cast<std::size_t>(set)];
}

bool isSupported(const Target& target) {
  return target.set == InstructionSet::Baseline || (hwy::SupportedTargets() & target.bit) != 0;
}

InstructionSet inUse = instructionSets().back();

}  // namespace

std::string_view name(InstructionSet set) {
  return targetOf(set).name;
}

std::vector<InstructionSet> instructionSets() {
  std::vector<InstructionSet> sets;
  for (const Target& target : kTargets)
    if (isSupported(target)) sets.push_back(target.set);
  return sets;
}

InstructionSet instructionSet() {
  return inUse;
}

void useInstructionSet(InstructionSet set) {
  const Target& target = targetOf(set);
  if (!isSupported(target)) {
    std::vector<std::string_view> names;
    for (const InstructionSet one : instructionSets()) names.push_back(name(one));
    throw std::invalid_argument(
        fmt::format("instruction set '{}' is not one that this processor has; it has: {}",
                    target.name, fmt::join(names, ", ")));
  }
  hwy::GetChosenTarget().Update(target.bit);
  inUse = set;
}

InstructionSet findInstructionSet(std::string_view name) {
  return findByName(kTargets, &Target::name, "instruction set", name).set;
}

}  // namespace wells
