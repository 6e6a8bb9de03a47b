#include "predictors.h"

#include <memory>

#include "engines.h"

namespace wells {

Predictor makeOneBallPredictor(std::string_view engine) {
  struct OneBall {
    std::unique_ptr<Stepper> stepper;
    World world;
  };
  const auto alone = std::make_shared<OneBall>();  // a Predictor can be copied, a Stepper cannot
  alone->stepper = makeEngine(engine);
  return [alone](const World& world, std::size_t ball, const BallState& state, std::int64_t from,
                 std::int64_t to) {
    World& copy = alone->world;
    copy.settings = world.settings;
    copy.arena = world.arena;
    copy.tracks = world.tracks;
    copy.step = from;
    copy.balls = {};
    copy.balls.add(state, world.balls.radius[ball], world.balls.mass[ball]);
    while (copy.step < to) alone->stepper->step(copy);
    return copy.balls.state(0);
  };
}

}  // namespace wells
