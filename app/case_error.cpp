#include "case_error.h"

#include <algorithm>
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

/// m, the largest change of a height or of a distance between two balls.
double deformation(const Balls& before, const Balls& now) {
  double worst = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    worst = std::max(worst, std::abs(now.position[i].y() - before.position[i].y()));
    for (std::size_t j = 0; j < i; ++j)
      worst = std::max(worst, std::abs(length(now.position[i] - now.position[j]) -
                                       length(before.position[i] - before.position[j])));
  }
  return worst;
}

}  // namespace

CaseError::CaseError(const AccuracyCase& answer, const World& start)
    : answer_(answer), start_(start.balls), startEnergy_(measure(start).energy()) {}

void CaseError::beginStep(const World& world) {
  if (answer_.error != ErrorKind::Energy && answer_.error != ErrorKind::Penetration) return;
  const Measures now = measure(world);
  const double deviation = now.energy() - startEnergy_;
  sum_ += answer_.error == ErrorKind::Energy ? deviation * deviation : now.squaredOverlaps;
  ++steps_;
}

double CaseError::atTheEnd(const World& world) const {
  if (answer_.error == ErrorKind::Position) return positionError(answer_, world);
  if (!isAllFinite(world.balls)) return std::numeric_limits<double>::infinity();
  if (answer_.error == ErrorKind::Deformation) return deformation(start_, world.balls);
  if (answer_.error == ErrorKind::EndEnergy)
    return std::abs(kineticEnergy(world.balls) / answer_.endEnergy - 1);
  const double mean = sum_ / static_cast<double>(steps_);
  return answer_.error == ErrorKind::Energy ? std::sqrt(mean) / startEnergy_ : mean;
}

}  // namespace wells
