#include "case_error.h"

#include <cmath>
#include <limits>

#include "world/measures.h"

namespace wells {
namespace {

bool isAllFinite(const Balls& balls) {
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (!isFinite(balls.state(i))) return false;
  return true;
}

}  // namespace

CaseError::CaseError(const AccuracyCase& answer, const World& start)
    : answer_(answer), startEnergy_(measure(start).energy()) {}

void CaseError::beginStep(const World& world) {
  if (answer_.error == ErrorKind::Position) return;
  const Measures now = measure(world);
  const double deviation = now.energy() - startEnergy_;
  sum_ += answer_.error == ErrorKind::Energy ? deviation * deviation : now.squaredOverlaps;
  ++steps_;
}

double CaseError::atTheEnd(const World& world) const {
  if (answer_.error == ErrorKind::Position) return positionError(answer_, world);
  if (!isAllFinite(world.balls)) return std::numeric_limits<double>::infinity();
  const double mean = sum_ / static_cast<double>(steps_);
  return answer_.error == ErrorKind::Energy ? std::sqrt(mean) / startEnergy_ : mean;
}

}  // namespace wells
