#include "baseline/bullet.h"

#include <optional>

#include "baseline/bullet_scene.h"
#include "forces/field.h"

namespace wells {
namespace {

bool same(const BallState& a, const BallState& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin;
}

bool samePhysics(const Settings& a, const Settings& b) {
  return a.gravity == b.gravity && a.drag == b.drag && a.elasticity == b.elasticity &&
         a.friction == b.friction && a.rollingResistance == b.rollingResistance;
}

class BulletStepper : public Stepper {
 public:
  explicit BulletStepper(const BulletOptions& options) : options_(options) {}

  std::string name() const override { return "bullet"; }
  std::string integrator() const override { return "symplectic-euler"; }
  std::string contactMethod() const override { return "sequential-impulse"; }
  StepCounts counts() const override { return scene_ ? scene_->counts() : StepCounts{}; }

  void step(World& world) override {
    takeUpChanges(world);
    pull(world);
    scene_->step(world.settings.dt);
    writeBack(world.balls);
    ++world.step;
  }

 private:
  void takeUpChanges(const World& world) {
    if (!scene_ || !scene_->fits(world)) {
      scene_.emplace(world, options_.sleeping);
      left_.clear();
    } else if (!samePhysics(applied_, world.settings)) {
      scene_->apply(world.settings);
    }
    applied_ = world.settings;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const BallState now = world.balls.state(i);
      if (!same(now, left_[i])) scene_->setBall(i, now);
    }
  }

  void pull(const World& world) {
    Field wells = fieldOf(world);
    wells.gravity.setZero();  // Bullet adds it
    if (wells.wells.empty()) return;
    const Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (scene_->sleeps(i)) continue;
      scene_->addForce(i, acceleration(wells, balls.position[i], 0) * balls.mass[i]);
    }
  }

  void writeBack(Balls& balls) {
    left_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      left_[i] = scene_->ball(i);
      balls.setState(i, left_[i]);
    }
  }

  const BulletOptions options_;
  std::optional<BulletScene> scene_;
  Settings applied_;
  std::vector<BallState> left_;  // what the last step left in the world
};

}  // namespace

std::unique_ptr<Stepper> makeBullet(const BulletOptions& options) {
  return std::make_unique<BulletStepper>(options);
}

}  // namespace wells
