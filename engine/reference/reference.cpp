#include "reference/reference.h"

#include <array>
#include <string>

#include "reference/detection.h"
#include "reference/integrators.h"
#include "reference/resolver.h"

namespace wells {
namespace {

struct Method {
  ReferenceVariant variant;
  std::string_view name;
  std::string_view integrator;
  void (*advance)(const ReferenceStep&, ReferenceBall&);
};

// In the order of ReferenceVariant.
constexpr std::array kMethods{
    Method{ReferenceVariant::Euler, "reference-euler", "euler", advanceEuler},
    Method{ReferenceVariant::ImprovedEuler, "reference-improved-euler", "improved-euler",
           advanceImprovedEuler},
    Method{ReferenceVariant::RungeKutta, "reference-rk", "rk", advanceRungeKutta},
    Method{ReferenceVariant::Heun, "reference-heun", "heun", advanceHeun},
    Method{ReferenceVariant::Rk4, "reference-rk4", "rk4", advanceRk4},
};

ReferenceStep stepOf(const World& world) {
  const Settings& settings = world.settings;
  ReferenceStep step{.gravity = settings.gravity,
                     .wells = fieldOf(world),
                     .h = settings.dt,
                     .damping = settings.drag,
                     .dampingOfStep = dragFactor(settings.drag, settings.dt)};
  step.wells.gravity.setZero();
  return step;
}

class ReferenceStepper : public Stepper {
 public:
  ReferenceStepper(const Method& method, const ReferenceOptions& options)
      : method_(method), options_(options) {}

  std::string name() const override { return std::string{method_.name}; }
  std::string integrator() const override { return std::string{method_.integrator}; }
  std::string contactMethod() const override { return "manifold"; }
  StepCounts counts() const override { return counts_; }

  void step(World& world) override {
    takeUpChanges(world.balls);
    move(world);
    detect(world);
    resolve(world);
    carried().position = world.balls.position;
    carried().velocity = world.balls.velocity;
    ++world.step;
  }

  const StepperMemory* memory() const override { return &memory_; }
  void restore(const StepperMemory& memory) override { memory_.carried = memory.carried; }

 private:
  StepperMemory::Carried& carried() { return memory_.carried; }

  void takeUpChanges(const Balls& balls) {
    const std::size_t known = carried().position.size() == balls.size() ? balls.size() : 0;
    carried().lastVelocity.resize(balls.size());
    carried().force.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (i < known && balls.position[i] == carried().position[i] &&
          balls.velocity[i] == carried().velocity[i]) {
        continue;
      }
      carried().lastVelocity[i] = balls.velocity[i];
      carried().force[i].setZero();
    }
  }

  void move(World& world) {
    const ReferenceStep step = stepOf(world);
    Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      ReferenceBall ball{balls.position[i],  balls.velocity[i], carried().lastVelocity[i],
                         carried().force[i], balls.mass[i],     1 / balls.mass[i]};
      method_.advance(step, ball);
      balls.position[i] = ball.position;
      balls.velocity[i] = ball.velocity;
      carried().lastVelocity[i] = ball.lastVelocity;
      carried().force[i] = ball.force;
    }
  }

  void detect(World& world) {
    manifold_.clear();
    detectGround(world, carried().force, manifold_);
    detectWall(world, manifold_);
    detectPairs(world, pairs_, manifold_);
    counts_.contacts = static_cast<std::int64_t>(manifold_.size());
  }

  void resolve(World& world) {
    resolver_.resolve(manifold_, world.balls,
                      {.elasticity = world.settings.elasticity,
                       .acceleration = world.settings.gravity,
                       .h = world.settings.dt,
                       .maxIterations = options_.iterations.value_or(2 * counts_.contacts)});
  }

  const Method& method_;
  const ReferenceOptions options_;
  StepCounts counts_;
  StepperMemory memory_;  // what is carried
  // Kept for their memory.
  TouchingPairs pairs_;
  Manifold manifold_;
  Resolver resolver_;
};

}  // namespace

std::unique_ptr<Stepper> makeReference(ReferenceVariant variant, const ReferenceOptions& options) {
  return std::make_unique<ReferenceStepper>(kMethods[static_cast<std::size_t>(variant)], options);
}

std::optional<ReferenceVariant> referenceVariant(std::string_view name) {
  for (const Method& method : kMethods) {
    if (method.name == name) return method.variant;
  }
  return std::nullopt;
}

std::vector<std::string_view> referenceNames() {
  std::vector<std::string_view> names;
  for (const Method& method : kMethods) names.push_back(method.name);
  return names;
}

}  // namespace wells
