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
    leftPosition_ = world.balls.position;
    leftVelocity_ = world.balls.velocity;
    ++world.step;
  }

 private:
  void takeUpChanges(const Balls& balls) {
    const std::size_t known = leftPosition_.size() == balls.size() ? balls.size() : 0;
    lastVelocity_.resize(balls.size());
    force_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (i < known && balls.position[i] == leftPosition_[i] &&
          balls.velocity[i] == leftVelocity_[i]) {
        continue;
      }
      lastVelocity_[i] = balls.velocity[i];
      force_[i].setZero();
    }
  }

  void move(World& world) {
    const ReferenceStep step = stepOf(world);
    Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      ReferenceBall ball{balls.position[i], balls.velocity[i], lastVelocity_[i],
                         force_[i],         balls.mass[i],     1 / balls.mass[i]};
      method_.advance(step, ball);
      balls.position[i] = ball.position;
      balls.velocity[i] = ball.velocity;
      lastVelocity_[i] = ball.lastVelocity;
      force_[i] = ball.force;
    }
  }

  void detect(World& world) {
    manifold_.clear();
    detectGround(world, force_, manifold_);
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
  // By ball.
  std::vector<Vec3> lastVelocity_;
  std::vector<Vec3> force_;
  // What the last step left in the world, to notice changes from outside.
  std::vector<Vec3> leftPosition_;
  std::vector<Vec3> leftVelocity_;
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
