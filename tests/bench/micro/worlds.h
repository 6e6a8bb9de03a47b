// Worlds for the micro-benchmarks, made once: as a step finds them, in the midst of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contacts/path.h"
#include "forces/field.h"
#include "state/world.h"

namespace wells {

/// T1: balls that have come down and lie on each other.
const World& heap(std::size_t balls);

/// T2: balls that fly about and meet now and then.
const World& gas(std::size_t balls);

/// What a step knows of a world before it looks for pairs.
struct StepStart {
  explicit StepStart(const World& world);

  std::vector<double> reach;         // m, by ball
  std::vector<std::uint32_t> balls;  // all
};

/// What paths need of a world, which must outlive it.
struct Model {
  explicit Model(const World& world);

  Field field;
  PathModel path;
};

/// One step further, by our engine.
World afterStep(World world);

}  // namespace wells
