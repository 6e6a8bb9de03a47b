// The error of one run of an accuracy case, gathered from step to step.
#pragma once

#include <cstdint>

#include "scenes/exact_answers.h"

namespace wells {

class CaseError {
 public:
  /// `start`: the world before its first step. Keeps a reference to `answer`.
  CaseError(const AccuracyCase& answer, const World& start);

  /// To be called before each step. Costs a measure() where the error is not one of the end.
  void beginStep(const World& world);

  /// In the unit of the case's kind of error; infinite if a ball is not finite at the end.
  double atTheEnd(const World& world) const;

 private:
  const AccuracyCase& answer_;
  Balls start_;
  double startEnergy_ = 0;  // J
  double sum_ = 0;          // of what is averaged
  std::int64_t steps_ = 0;
};

}  // namespace wells
