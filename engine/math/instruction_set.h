// Which of the processor's instruction sets the vector code uses. The best one, unless told
// otherwise: all compute the same bits, so this changes nothing but the time.
//
// Vector code is written once with Highway (https://github.com/google/highway), compiled for each
// set, and chosen at each call. Lanes are independent balls or contacts; no sum goes across them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wells {

enum class InstructionSet : std::uint8_t {
  Baseline,  // what every x86-64 has; one ball or contact at a time
  Avx2,      // four doubles at a time
  Avx512     // eight; asks for F, BW, CD, DQ and VL
};

std::string_view name(InstructionSet set);

/// Those that this processor has, the best one last. Never empty.
std::vector<InstructionSet> instructionSets();

/// The one in use.
InstructionSet instructionSet();

/// From now on, in all threads; not while vector code runs. Throws std::invalid_argument where this
/// processor has no such set.
void useInstructionSet(InstructionSet set);

/// The set of that name, or throws std::invalid_argument with the names that exist.
InstructionSet findInstructionSet(std::string_view name);

}  // namespace wells
