#include "baseline/bullet.h"
#include "engines.h"
#include "predictors.h"

namespace wells {

bool hasEngine(std::string_view name) {
  return name == "bullet";
}

std::unique_ptr<Stepper> makeEngine(std::string_view, Sleeping sleeping, int) {
  return makeBullet({sleeping == Sleeping::On ? BulletSleeping::On : BulletSleeping::Off});
}

Predictor makePredictor(std::string_view engine) {
  return makeOneBallPredictor(engine);
}

}  // namespace wells
