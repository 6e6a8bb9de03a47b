// One run of the work-precision benchmark: a case, a method, a number of steps. Says what to run;
// runs nothing.
#pragma once

#include <memory>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "state/stepper.h"
#include "work_precision.h"

namespace wells {

struct AccuracyTask {
  const AccuracyCase& answer;
  const Scene& scene;
  const Method& method;
  std::int64_t steps;

  double dt() const { return answer.duration / static_cast<double>(steps); }  // s

  /// The world at its start.
  World world() const;

  /// An engine that has not stepped; of this executable.
  std::unique_ptr<Stepper> stepper() const;
};

}  // namespace wells
