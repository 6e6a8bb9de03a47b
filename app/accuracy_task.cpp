#include "accuracy_task.h"

#include "engines.h"

namespace wells {

World AccuracyTask::world() const {
  World start = makeScene(scene);
  start.settings.dt = dt();
  if (method.engine != "ours") return start;
  start.settings.integrator = method.integrator;
  start.settings.contactMethod = *contactMethod(method.contacts);
  if (!scene.sleeping) start.settings.sleepSpeed = 0;
  return start;
}

std::unique_ptr<Stepper> AccuracyTask::stepper() const {
  return makeEngine(method.engine, scene.sleeping ? Sleeping::On : Sleeping::Off);
}

}  // namespace wells
