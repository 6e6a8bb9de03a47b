#include "engines.h"
#include "predictors.h"
#include "reference/reference.h"
#include "world/prediction.h"
#include "world/simulation.h"

namespace wells {

bool hasEngine(std::string_view name) {
  return name == "ours" || referenceVariant(name);
}

std::unique_ptr<Stepper> makeEngine(std::string_view name, Sleeping, int threads) {
  if (const auto variant = referenceVariant(name)) return makeReference(*variant);
  return makeSimulation({.threads = threads});
}

Predictor makePredictor(std::string_view engine) {
  if (engine == "ours") return predict;
  return makeOneBallPredictor(engine);
}

}  // namespace wells
