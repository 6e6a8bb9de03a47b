#include "planted/defects.h"

namespace wells::planted {
namespace {

constexpr Defect kDefects[] = {
#include "defects.inc"
};

}  // namespace

std::span<const Defect> defects() {
  return kDefects;
}

}  // namespace wells::planted
